"""What a late speed makes of its difference to the position goes along with the speed."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.signal import lfilter

from simpter_hybrid.identification.recordings.off_axis import off_axis
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun

STEP = 0.002
TIME = STEP * np.arange(5000)
CHANNELS = {
    name: SimpleNamespace(unit=unit, role="measured")
    for name, unit in (("position", "rad"), ("speed", "rad/s"))
}


def lagging(speed, late):
    kept = np.exp(-STEP / late)
    return lfilter([1.0 - kept], [1.0, -kept], speed, zi=[kept * speed[0]])[0]


def delayed(speed, late):
    rows = round(late / STEP)
    return np.concatenate([np.full(rows, speed[0]), speed[:-rows]])


def pendulums(shown, late, wave):
    """Four that swing far under their weight, with the angle off by a wave of it."""
    random, made = np.random.default_rng(3), []
    for k, angle in enumerate((2.5, 2.2, 2.8, 2.0)):
        fall = solve_ivp(
            lambda _, y: [y[1], -20.0 * np.sin(y[0]) - 0.05 * y[1]], (0.0, 10.0), [angle, 0.0],
            t_eval=TIME, rtol=1e-8, atol=1e-8,
        )  # fmt: skip
        place, speed = fall.y
        seen = place + wave * np.sin(place + 0.5) + 1e-5 * random.standard_normal(TIME.size)
        told = shown(speed, late) + 1e-3 * random.standard_normal(TIME.size)
        both = {"position": seen, "speed": told}
        made.append(RecordedRun(f"run {k}", "", "", (0, TIME.size), TIME, both))
    return made


@pytest.mark.parametrize("shown", [lagging, delayed])
def test_the_wave_is_told_with_its_size(shown):
    (found,) = off_axis(pendulums(shown, 0.006, 0.012), CHANNELS)
    # A delay of 6 ms leaves 0.36 mrad of such a wave beside it.
    assert found.size == pytest.approx(0.012, abs=6e-4)


@pytest.mark.parametrize("shown", [lagging, delayed])
@pytest.mark.parametrize("late", [0.006, 0.02])
def test_what_a_speed_leaves_beside_its_lag_is_no_wave(shown, late):
    assert list(off_axis(pendulums(shown, late, 0.0), CHANNELS)) == []
