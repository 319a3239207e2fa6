"""Curves fitted where no law is known: knots, ends, turns, and lines that a law knows too."""

import math

import numpy as np
import pytest
from effect_rig import rig

from simpter_hybrid.effects.drift import Drift
from simpter_hybrid.effects.empirical_channel import EmpiricalByChannel, by_four
from simpter_hybrid.effects.empirical_friction import (
    EmpiricalByAngle,
    EmpiricalByExcitation,
    EmpiricalByPosition,
    EmpiricalBySlip,
    EmpiricalBySpeed,
)
from simpter_hybrid.effects.empirical_history import (
    EmpiricalByDistance,
    EmpiricalByHeat,
    EmpiricalByReversal,
    EmpiricalByTime,
)
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.sampling import sample

KNOTS = (0.1, -0.2, 0.3, 0.05, -0.4, 0.2, 0.1)
ALONG = [
    (EmpiricalBySpeed, lambda x: (abs(x),)),
    (EmpiricalBySlip, lambda x: (abs(x), math.copysign(1.0, x))),
    (EmpiricalByPosition, lambda x: (x,)), (EmpiricalByAngle, lambda x: (x,)),
    (EmpiricalByExcitation, lambda x: (x,)), (EmpiricalByTime, lambda x: (x,)),
    (EmpiricalByDistance, lambda x: (x,)), (EmpiricalByHeat, lambda x: (x,)),
    (EmpiricalByReversal, lambda x: (math.copysign(1.0, x), abs(x))),
]  # fmt: skip


@pytest.mark.parametrize(("cls", "signals"), ALONG, ids=lambda a: getattr(a, "__name__", ""))
def test_it_passes_through_its_knots_and_is_constant_beyond(cls, signals):
    knots = KNOTS[: len(cls.sizes)]
    for k, change in enumerate(knots):
        told = cls.slip_torque(2.0, *signals(1.0 + 0.5 * k), 1.0, 4.0, *knots)
        assert told == pytest.approx(2.0 * (1.0 + change), rel=1e-12)
    beyond = cls.slip_torque(2.0, *signals(4.2), 1.0, 4.0, *knots)
    inside = cls.slip_torque(2.0, *signals(1.2), 1.0, 4.0, *knots)
    expected = inside if cls is EmpiricalByAngle else 2.0 * (1.0 + KNOTS[-1])
    assert beyond == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("cls", [cls for cls, _ in ALONG], ids=lambda c: c.__name__)
def test_its_ends_must_be_in_order(cls):
    with pytest.raises(ValueError, match="high above low"):
        cls(low=2.0, high=1.0)


def test_friction_never_pushes():
    assert EmpiricalByTime.slip_torque(2.0, 0.5, 0.0, 1.0, *(-3.0,) * 7) == 0.0


def test_a_straight_curve_over_time_is_drift():
    # Between its second and sixth knot the curve through points of a line is that line.
    line = {f"c{k + 1}": 0.3 * (-1.0 + 0.5 * k) for k in range(7)}
    curve = EmpiricalByTime(clutch=0, low=-1.0, high=2.0, **line)
    told, known = (simulate(rig([e])) for e in (curve, Drift(clutch=0, rate_per_time=0.3)))
    # Solver tolerance 1e-10, some ten events.
    np.testing.assert_allclose(told.end[:3], known.end[:3], atol=1e-8)


def test_a_straight_curve_over_a_channel_that_shows_the_time_is_drift():
    line = {f"c{k + 1}": 0.3 * (0.5 * k) for k in range(4)}
    clock = tuple((t, t) for t in np.linspace(-1.0, 2.0, 31))  # level only at its ends
    curve = EmpiricalByChannel(clutch=0, channel="clock", points=clock, low=0.0, high=1.5, **line)
    told, known = (simulate(rig([e])) for e in (curve, Drift(clutch=0, rate_per_time=0.3)))
    # Solver tolerance 1e-10, some ten events.
    np.testing.assert_allclose(told.end[:3], known.end[:3], atol=1e-8)


@pytest.mark.parametrize("place", [1.0, 1.5, 2.0, 2.5, 9.0])
def test_a_curve_over_a_channel_passes_through_its_knots_and_is_constant_beyond(place):
    knots = (0.1, -0.2, 0.3, 0.05)
    told = by_four(place, 1.0, 2.5, *knots)
    assert told == pytest.approx(1.0 + knots[min(3, round(2.0 * (place - 1.0)))], rel=1e-12)


def test_the_way_since_a_reversal_bends_exponentially():
    way = 0.3
    effect = EmpiricalByReversal(clutch=0, way=way, **{f"c{k}": 0.0 for k in range(1, 8)})
    run = simulate(rig([effect]))
    seen = sample(run, np.linspace(0.0, run.t_end, 400))
    one_way = np.flatnonzero(seen.slip[:, 0] <= 0.0)[0]
    slid = seen.q[:one_way, 0] - seen.q[0, 0]
    (bend,) = seen.effect.values()
    # From 0 and one way: bend = 1 - exp(-s/way); solver tolerance.
    np.testing.assert_allclose(bend[:one_way], 1.0 - np.exp(-slid / way), atol=1e-7)
    assert slid.max() > way
