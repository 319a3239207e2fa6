"""Runs that change alike at another level of drive and speed are courses of their own."""

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.repeats import same_course

TIME = np.linspace(0.0, 0.3, 300)
RISE = 1.0 - np.exp(-TIME / 0.02)


def step(level, size=0.1, drive=1.0, speed=1.0, noise=0.0, seed=0):
    """A motor at a level of volts that is raised; drive and speed by some part more."""
    white = noise * np.random.default_rng(seed).standard_normal((2, TIME.size))
    volts = level + size * (TIME > 0.01)
    turning = 20.0 * (level + size * RISE)
    return {"drive": drive * volts + white[0], "speed": speed * turning + 20.0 * white[1]}


@pytest.mark.parametrize("size", [0.1, -0.1])
@pytest.mark.parametrize("drives", ["drive", "duty", "current", "torque_1"])
def test_the_next_step_is_another_course(size, drives):
    one, other = step(2.0), step(1.9, size)
    one[drives], other[drives] = one.pop("drive"), other.pop("drive")
    assert not same_course(one, other)


def test_the_same_step_is_the_same():
    assert same_course(step(2.0, noise=0.01, seed=1), step(2.0, noise=0.01, seed=2))


@pytest.mark.parametrize("what", ["drive", "speed"])
def test_a_friction_that_is_another_today_makes_no_other_course(what):
    # At the same voltage another speed, or at a servo's speed another voltage.
    assert same_course(step(2.0), step(2.0, **{what: 1.03}))


def test_noise_about_a_level_does_not_change_alike():
    runs = [step(2.0 + 0.03 * k, size=0.0, noise=0.01, seed=k) for k in (0, 1)]
    assert same_course(*runs)


def test_a_supply_that_gives_a_little_more_makes_no_other_course():
    wave = np.sin(20.0 * TIME)
    runs = [{"drive": k * (5.0 + 0.2 * wave), "speed": k * (50.0 + 2.0 * wave)} for k in (1, 1.005)]
    assert same_course(*runs)
