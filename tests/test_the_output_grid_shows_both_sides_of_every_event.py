"""Default output: multiples of the step, and every event from both sides."""

import numpy as np
import pytest
from sampled_runs import baseline

from simpter_hybrid.measuring.sampling import output_grid, sample


def test_every_event_is_there_from_both_sides():
    t, side = output_grid(baseline())
    found = set(zip(t.tolist(), side.tolist(), strict=True))
    for event in baseline().events:
        if 0.0 < event.t < baseline().t_end:
            assert {(event.t, "left"), (event.t, "right")} <= found
    assert (np.diff(t) >= 0.0).all()


def test_the_two_sides_have_the_modes_of_the_event():
    run = baseline()
    events = [event for event in run.events if 0.0 < event.t < run.t_end]
    times = [event.t for event in events]
    before, after = sample(run, times, "left").mode, sample(run, times, "right").mode
    assert [tuple(row) for row in before.tolist()] == [event.before for event in events]
    assert [tuple(row) for row in after.tolist()] == [event.after for event in events]


def test_the_step_has_to_be_positive():
    with pytest.raises(ValueError, match="greater than 0 s"):
        output_grid(baseline(), 0.0)
