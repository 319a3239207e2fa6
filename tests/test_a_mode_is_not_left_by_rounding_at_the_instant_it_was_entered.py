"""Ties of guards at one instant, which toggled for ever; the other engine gives the number."""

import pytest

from simpter_hybrid import compiled, engine
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.profile import CommandProfile
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.effects.clutch_backlash import ClutchBacklash
from simpter_hybrid.effects.command_slew import CommandSlew
from simpter_hybrid.effects.play_hysteresis import PlayHysteresis
from simpter_hybrid.effects.remanence import Remanence
from simpter_hybrid.laws import CoulombViscous, LinearTorque
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.scenario import Scenario


def same_by_both_engines(run):
    ends = []
    for simulate in (engine.simulate, compiled.simulate):
        found = simulate(run)
        assert found.status == "finished", found.message
        ends.append(found.end[:2])
    # Two engines at a tolerance of 1e-10 a step.
    assert ends[0] == pytest.approx(ends[1], rel=1e-7)


@pytest.mark.parametrize(
    ("stiffness", "load", "gap"), [(1e4, 8.0, 2e-3), (1e4, 20.0, 0.0), (1e3, 20.0, 2e-3)]
)
def test_a_plate_begins_to_slide_where_breakaway_is_the_slip_torque(stiffness, load, gap):
    clutch = Clutch(CoulombViscous(coulomb=5.0), time_constant=0.0, delay=0.0, threshold=-1.0)
    run = Scenario("tie", LinearAxis(1.0), (clutch,), (0.0,), (0.0,), 0.3)
    effect = ClutchBacklash(clutch=0, gap=gap, stiffness=stiffness)
    ramp = RampOnCoordinate(base=0.0, slope=10.0 * load, limit=load)
    same_by_both_engines(run.replace(effects=(effect,), loads=(ramp,)))


@pytest.mark.parametrize(
    ("play", "turned"),
    [
        (Remanence(clutch=0, width=0.3), 0.055),
        (PlayHysteresis(clutch=0, share=0.5, width=0.3), 0.06),
    ],
)
def test_a_play_is_left_where_the_rate_of_its_excitation_goes_smoothly_through_zero(play, turned):
    command = CommandProfile(((0.0, 5.0), (turned, 5.0), (turned, 0.5), (1.0, 0.5)))
    clutch = Clutch(LinearTorque(10.0), time_constant=0.03, delay=0.0)
    run = Scenario("tie", LinearAxis(1.0), (clutch,), (0.0,), (10.0,), 0.4, period=0.005)
    slew = CommandSlew(clutch=0, slowness=0.02, slowness_down=0.03)
    same_by_both_engines(run.replace(effects=(slew, play), controllers=((command, 1),)))
