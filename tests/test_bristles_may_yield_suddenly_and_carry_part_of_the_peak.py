"""LuGre's bristles with an exponent, and with a peak of which they carry a part."""

from math import cosh, exp, log

import pytest
from devices_for_tests import Block, always_on

from simpter_hybrid.effects.lugre import LuGre
from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

SLIP, BREAK, HEAVY, PACE = 2.0, 2.6, 1e12, 0.3


def lost(bristles, brk, t_end):
    """Work of friction along a steady motion; the way is `PACE` times `t_end`."""
    run = Scenario("pulled", Block(HEAVY, 0.0), (always_on(SLIP, brk),), (0.0,), (PACE,), t_end)
    told = {"effects": (bristles,), "command": (1.0,), "excitation": (1.0,)}
    return simulate(run.replace(**told)).end[-1]


def test_with_exponent_two_friction_is_the_hyperbolic_tangent_of_the_way():
    displacement, way = 0.05, 0.2
    bristles = LuGre(clutch=0, displacement=displacement, exponent=2.0)
    work = SLIP * displacement * log(cosh(way / displacement))
    assert lost(bristles, SLIP, way / PACE) == pytest.approx(work, rel=1e-8)


@pytest.mark.parametrize("carried", [0.0, 0.4, 1.0])
@pytest.mark.parametrize("exponent", [0.7, 1.0, 3.0])
def test_steady_sliding_resists_the_same_whatever_the_bristles_carry(carried, exponent):
    fade, displacement = 0.4, 1e-3
    bristles = LuGre(clutch=0, displacement=displacement, fade=fade, exponent=exponent,
                     carried=carried)  # fmt: skip
    level = SLIP + (BREAK - SLIP) * exp(-((PACE / fade) ** 2))
    # One second begins forty displacements after the start.
    second = lost(bristles, BREAK, 2.0) - lost(bristles, BREAK, 1.0)
    assert second == pytest.approx(level * PACE, rel=1e-8)
