"""Each channel that is left is judged by its own noise, whatever else was repeated."""

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.floor import replicate_noise
from simpter_hybrid.identification.fitting.lack_of_fit import lack_of_fit, residual_series
from simpter_hybrid.identification.fitting.replay import Observation, Replay

ROWS, SETS = 800, 100
#: A speed that is set anew from the record counts less.
WEIGHTS = {"torque": 1.0, "speed": 0.3}
TIME = 0.01 * np.arange(ROWS)
#: True noise, in times what the sensor is said to have.
TIMES = {"torque": 1.0, "speed": 1.5}


def _run(draw, channel, lack=0.0):
    noise = TIMES[channel] * draw.standard_normal(ROWS) + lack * np.sin(TIME)
    seen = Observation(0.1 * noise, 0.1, np.ones(ROWS, bool), WEIGHTS[channel])
    return Replay(channel, channel, TIME, {}, {channel: seen})


def _p_values(fitted, held_out, lack=0.0, sets=SETS):
    draw, found = np.random.default_rng(7), []
    for _ in range(sets):
        noise = replicate_noise([_run(draw, channel) for channel in fitted])
        runs = [_run(draw, channel, lack) for channel in held_out]
        flat = {channel: [np.zeros(ROWS)] * len(runs) for channel in WEIGHTS}
        found.append(lack_of_fit(residual_series(flat, runs), noise).p_value)
    return np.sort(found)


@pytest.mark.parametrize(
    ("fitted", "held_out"),
    [
        (["torque", "speed", "speed"], ["torque", "speed"]),
        (["torque", "torque", "speed", "speed", "speed"], ["torque", "torque", "speed"]),
        (["torque", "torque", "torque", "speed", "speed"], ["torque", "speed", "speed"]),
    ],
    ids=["speed alone", "more of the speed", "more of the torque"],
)
def test_where_nothing_is_missing(fitted, held_out):
    p = _p_values(fitted, held_out)
    # Kolmogorov: 0.163 at 1 %.
    assert np.abs(p - (np.arange(SETS) + 0.5) / SETS).max() < 0.163


@pytest.mark.parametrize("fitted", [["speed"] * 2, ["torque"] * 2])
def test_what_is_missing_is_told(fitted):
    assert _p_values(fitted, ["torque", "torque"], lack=1.2, sets=10).max() < 0.01
