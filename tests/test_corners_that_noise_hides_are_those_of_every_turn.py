"""A tester turns as sharply each time: what noise hides of one corner, all of them show."""

import numpy as np

from simpter_hybrid.identification.axis.position_motion import motion_of

STEP, NOISE = 1e-3, 5e-7
TIME = STEP * np.arange(8000)
GENERATOR = np.random.default_rng(4)
#: From the turn in each half second [s].
AFTER = (TIME + 0.25) % 0.5 - 0.25


def _resolved(course):
    return motion_of(course + GENERATOR.normal(0.0, NOISE, TIME.size), STEP, NOISE, 0.1).resolved


def test_around_sharp_turns_nothing_is_resolved():
    way = 1.0 - 2.0 * (np.round(2.0 * TIME) % 2.0)
    speed = 0.02 * way * np.clip(AFTER / 0.005, -1.0, 1.0)  # it takes 10 ms
    resolved = _resolved(np.cumsum(speed) * STEP)
    inside = (TIME > 0.1) & (TIME < 7.9)
    assert not resolved[inside & (np.abs(AFTER) < 0.005)].any()
    # Windows of 150 ms at most; a row in a thousand that chance makes unsure takes one along.
    assert resolved[np.abs(AFTER) > 0.15].mean() > 0.9


def test_smooth_turns_are_resolved():
    resolved = _resolved(0.02 / (2 * np.pi) * np.cos(2 * np.pi * TIME))
    # Windows differ there as noise has it, within 15 % of its square root of some hundred rows.
    assert resolved[np.abs(AFTER) < 0.005].mean() > 0.9
