"""Two springs side by side along a prescribed motion: a broken line, and the area of its loop."""

from math import exp, pi

import pytest
from devices_for_tests import Block, Waves, always_on
from effect_rig import rig

from simpter_hybrid.effects.maxwell_slip import MaxwellSlip
from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

SLIP, BREAK, HEAVY, PACE = 2.0, 2.6, 1e12, 0.3
SPRINGS = {"stiffness": 100.0, "share": 0.4, "steep": 0.7}
YIELDS = (0.4 * SLIP / 70.0, 0.6 * SLIP / 30.0)


def lost(effect, speed, t_end, brk=SLIP, loads=(), start=0.0):
    """Work against friction of a mass that nothing slows."""
    run = Scenario("moved", Block(HEAVY, 0.0), (always_on(SLIP, brk),), (start,), (speed,), t_end)
    told = {"effects": (effect,), "command": (1.0,), "excitation": (1.0,), "loads": loads}
    return simulate(run.replace(**told)).end[-1]


def test_each_spring_takes_a_triangle_and_then_its_share():
    way = 0.2
    work = sum(
        part * SLIP * (way - 0.5 * end) for part, end in zip((0.4, 0.6), YIELDS, strict=True)
    )
    found = lost(MaxwellSlip(clutch=0, **SPRINGS), PACE, way / PACE)
    assert found == pytest.approx(work, rel=1e-8)


def test_a_cycle_loses_four_times_share_and_slip_of_every_spring():
    amplitude, turns = 0.1, 10.0
    shaken = Waves(((0.0, HEAVY * amplitude * turns**2, turns, 0.5 * pi),))
    effect = MaxwellSlip(clutch=0, **SPRINGS, relaxation=1e-4)
    cycle = 2.0 * pi / turns
    cycles = [lost(effect, 0.0, k * cycle, loads=(shaken,), start=-amplitude) for k in (1.0, 2.0)]
    area = sum(
        4.0 * part * SLIP * (amplitude - end) for part, end in zip((0.4, 0.6), YIELDS, strict=True)
    )
    # What is wound beyond a yield goes within the relaxation: some 1e-7 m of 0.1 m.
    assert cycles[1] - cycles[0] == pytest.approx(area, rel=1e-5)


@pytest.mark.parametrize("shape", [1.0, 2.0, 6.0])
def test_steady_sliding_resists_by_a_level_that_falls_with_speed(shape):
    fade = 0.4
    effect = MaxwellSlip(clutch=0, **SPRINGS, fade=fade, shape=shape, damping=1e-3)
    level = SLIP + (BREAK - SLIP) * exp(-((PACE / fade) ** shape))
    second = lost(effect, PACE, 2.0, BREAK) - lost(effect, PACE, 1.0, BREAK)
    assert second == pytest.approx(level * PACE, rel=1e-8)


def test_no_step_passes_over_a_corner_where_the_level_changes_fast():
    """Pushed to and fro, with a level that falls within 0.02 rad/s."""
    run = rig((MaxwellSlip(clutch=0, damping=1e-3),))
    coarse, fine = (simulate(run.replace(rtol=tol, atol=tol)).end[:3] for tol in (1e-9, 1e-11))
    # Steps at 1e-9, amplified some hundred times; corners that were passed over made 1e-5 and more.
    assert coarse == pytest.approx(fine, abs=2e-7)
