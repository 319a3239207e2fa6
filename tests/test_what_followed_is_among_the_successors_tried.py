"""Every event: all combinations are tried, and the equations do not refuse the one taken."""

import pytest
from sampled_runs import baseline, locked, oscillator

from simpter_hybrid.explanation.explain import event_notes, explain, explain_event


@pytest.mark.parametrize("run", [baseline, locked, oscillator])
def test_what_followed_is_among_the_successors_tried(run):
    trajectory = run()
    for index, event in enumerate(trajectory.events):
        e = explain_event(trajectory, index)
        if e.rounds[0].zero:
            assert len(e.candidates) == 3 ** len(e.rounds[0].zero)
            taken = [c for c in e.candidates if c.mode == event.after]
            assert [c.verdict for c in taken] != ["refused"]
        assert e.rounds[-1].after == event.after
        assert f"{event.t:.9g}" in str(e)


def test_other_consistent_successors_are_noted():
    # A breakaway torque far above the slip torque: a clutch that stops may stay or go on.
    run = locked(1.2)
    for index, note in enumerate(event_notes(run)):
        assert ("ambiguous" in note) == bool(explain_event(run, index).others)


def test_between_events_the_margins_then_are_told():
    event = baseline().events[3]
    text = str(explain(baseline(), event.t + 1e-4))
    assert "Nothing happens" in text
    assert f"{event.t:.9g}" in text


def test_outside_the_run_is_refused():
    with pytest.raises(ValueError, match="outside the run"):
        explain(baseline(), 100.0)
