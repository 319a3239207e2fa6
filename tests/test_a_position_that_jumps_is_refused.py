"""A wrapped angle and an outlier, against motion that is merely fast, coarse or interrupted."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.checks import _jumps
from simpter_hybrid.identification.recordings.jumps import jumps

TIME = np.arange(2000) * 0.002
SWING = 4.0 * np.sin(2.0 * np.pi * TIME)


@pytest.mark.parametrize("turn", [np.pi, 2.0 * np.pi])
def test_a_wrapped_angle(turn):
    wrapped = np.mod(SWING + 0.5 * turn, turn) - 0.5 * turn
    wraps = np.flatnonzero(np.abs(np.diff(wrapped)) > 0.5 * turn) + 1
    assert jumps(TIME, wrapped).tolist() == wraps.tolist()


def test_an_outlier():
    values = SWING.copy()
    values[700] += 6.28
    assert 700 in jumps(TIME, values)


@pytest.mark.parametrize(
    "values",
    [
        SWING,
        np.round(SWING / 0.05) * 0.05,  # a coarse encoder
        np.where(TIME < 3.0, 0.0, 20.0 * (TIME - 3.0)),  # struck out of rest
        np.cumsum(np.random.default_rng(1).standard_normal(TIME.size)) * 1e-3,
        np.zeros(TIME.size),
    ],
    ids=["swing", "coarse", "struck", "walk", "rest"],
)
def test_motion_is_none(values):
    assert jumps(TIME, values).size == 0


def test_what_moved_during_a_gap_did_not_jump():
    kept = (TIME < 1.0) | (TIME > 1.2)
    assert jumps(TIME[kept], SWING[kept]).size == 0


@pytest.mark.parametrize(("unit", "word"), [("deg", "unwrapped"), ("mm", "no outliers")])
def test_only_an_angle_is_said_to_wrap(unit, word):
    values = SWING.copy()
    values[700] += 6.28
    channel = SimpleNamespace(unit=unit, written_change=str, wraps=0.0)
    at = lambda k, what, value, right, fatal: right  # noqa: E731
    (right,) = set(_jumps("position", TIME, values, channel, at))
    assert word in right
    assert ("unwrapped" in right) == (unit == "deg")
