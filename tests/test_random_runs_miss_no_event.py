"""Random four-clutch runs against checks ten times as dense: no event missed, none invented."""

import pytest
from random_runs import KINDS, random_run
from same_events import first_difference, story_of

pytest.importorskip("numba")
#: 60 of each of the five kinds.
COUNT = 60
#: Guards are looked at every 2.2 ms (a ninth of the longest step); here every 0.22 ms [s].
DENSE = 0.002
#: Error of an event time where the guard is flat, with the integrator's error below 1e-12 [s].
FLAT = 1e-8


@pytest.mark.parametrize("kind", KINDS)
def test_three_hundred(kind):
    from simpter_hybrid.compiled import simulate

    events = 0
    for seed in range(COUNT):
        run = random_run(kind, seed)
        found, dense = simulate(run), simulate(run.replace(max_step=DENSE))
        assert found.status == dense.status == "finished", (seed, found.message)
        difference = first_difference(story_of(found), story_of(dense), FLAT)
        assert not difference, (seed, difference)
        assert found.end[:8] == pytest.approx(dense.end[:8], abs=1e-8), seed
        events += len(found.events)
    assert events > 10 * COUNT


def test_without_interior_checks_events_are_missed(monkeypatch):
    """The comparison can fail: one look a step, and long steps, lose events in some runs."""
    from simpter_hybrid.engine import simulate
    from simpter_hybrid.running import checked

    monkeypatch.setattr(checked, "first_dip", lambda *_: None)
    wrong = 0
    for seed in range(12):
        run = random_run("constant", seed, 2.0)
        blind, seeing = simulate(run.replace(max_step=0.5)), compiled(run)
        wrong += bool(first_difference(story_of(blind), story_of(seeing), FLAT))
    assert wrong >= 1


def compiled(run):
    from simpter_hybrid.compiled import simulate

    return simulate(run)
