"""Torque ramps of several slopes: a breakaway that falls with them is located there."""

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Breakaway, Replay
from simpter_hybrid.identification.rotor.traces import breakaway_trace
from simpter_hybrid.identification.tracing.signature import dependences

LEVEL = 100.0
RAMPS = (20.0, 40.0, 80.0, 160.0)


def _run(seed, fall):
    """Twelve breakaways after equal rests, both ways, that scatter by half a per cent."""
    rng = np.random.default_rng(seed)
    ramps = rng.permutation(np.repeat(RAMPS, 3))
    events = []
    for k, ramp in enumerate(ramps):
        level = LEVEL * (1.0 - fall * np.log(ramp / 50.0) + 0.005 * rng.standard_normal())
        events.append(Breakaway(100 * k + 50, level * (-1.0) ** k, 1.0, 1.0, ramp))
    time = 0.01 * np.arange(1200)
    run = Replay(f"run {seed}", "ramps", time, {}, {}, breakaways=tuple(events))
    return breakaway_trace(run, np.full(time.size, LEVEL))


@pytest.mark.parametrize(("fall", "leads"), [(0.05, True), (0.0, False)])
def test_levels_that_fall_with_the_slope_depend_on_it(fall, leads):
    found = dependences([_run(1, fall), _run(2, fall)], [_run(3, fall), _run(4, fall)])
    first = max(found, key=lambda d: d.gain)
    told = first.coordinate == "load_rate" and first.gain > 0.5 and first.p_value < 0.05
    assert told == leads
