"""Records grow with the run: thousands of segments, steps and events, alone and in a batch."""

import numpy as np
import pytest
from exact_runs import block_on_belt
from random_runs import random_run
from same_runs import differences

pytest.importorskip("llvmlite")
from simpter_hybrid import compiled, engine
from simpter_hybrid.ensemble import ensemble

#: 1,200 samples; room is made for 1,000 segments and 2,000 steps at first.
RUN = random_run("150 Hz", 4, 8.0)
#: Events of one run for which the ensemble makes room at first.
ROOM = 64


def test_more_than_1024_segments_are_those_of_the_reference_engine():
    found, reference = compiled.simulate(RUN), engine.simulate(RUN)
    assert len(found.segment_t) > 1024
    assert found.status == "finished"
    time, state = differences(reference, found)
    # Both solve to 1e-10 relative, over 8 s.
    assert time < 1e-9
    assert state < 1e-9


def test_in_a_batch_they_are_the_same_bytes():
    alone = compiled.simulate(RUN)
    found = ensemble(RUN, {"q.theta_1": np.full(3, RUN.q[0])}, trajectories=True)
    for case in range(3):
        run = found.trajectory(case)
        assert run.segment_t.tobytes() == alone.segment_t.tobytes()
        assert run.step_f.tobytes() == alone.step_f.tobytes()
        assert run.events == alone.events


def test_more_events_than_there_is_room_for_at_first():
    """Two events a period of stick and slip, each at its instant."""
    run, expected = block_on_belt()
    longer = run.replace(t_end=40.0 * run.t_end)
    found = ensemble(longer, {"q.x": np.array(run.q)})
    events = [e.t for e in found.events(0) if e.t > 0.0]
    assert len(events) > ROOM
    assert len(events) > 30 * len(expected)
    # The stick-slip cycle repeats itself, and the integrator's error grows with its number.
    period = float(expected[2][1] - expected[0][1])
    assert np.diff(events[::2]) == pytest.approx(period, abs=1e-8)
