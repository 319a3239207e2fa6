"""A compliant shaft, a compliant mount, a surface more: sound devices that do what they should."""

from math import cos, sqrt

import numpy as np
import pytest
from devices_for_tests import Coulomb, Ramp, Waves, always_on

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.device_check import check_device
from simpter_hybrid.devices.extended import with_drag, with_mount, with_shaft
from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.devices.testbed import SensorTestbed, Testbed
from simpter_hybrid.effects.backlash import Backlash
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario

PTER = Pter(33.0, 10.0, -1.3, 0.9, 0.6)


@pytest.mark.parametrize(
    "device",
    [
        with_shaft(PTER, 3, 0.2, 4e3, 1.0), with_mount(PTER, 2, 0.1, 2e4), with_drag(PTER, 3),
        with_shaft(with_drag(Testbed(0.1), 0), 0, 0.01, 100.0),
        with_mount(with_shaft(SensorTestbed(1.0, 0.1, 1e3, 0.5), 0, 0.1, 50.0, 0.1), 0, 0.3, 9.0),
    ],
    ids=lambda d: f"{type(d).__name__} {d.n} {d.m}",
)  # fmt: skip
def test_an_extended_device_is_sound(device):
    assert check_device(device) == []


def test_a_mount_under_the_testbeds_clutch_is_the_sensor_testbed():
    made = with_mount(Testbed(0.1), 0, 0.0752, 2791.0, 0.3)
    hand = SensorTestbed(0.1, 0.0752, 2791.0, 0.3)
    waves = Waves(((0, 8.0, 20.0, 0.0),))
    ends = []
    for device in (made, hand):
        run = Scenario("mount", device, (always_on(3.0, 4.0),), (0.0, 0.0), (1.0, 0.0), 0.3)
        run = run.replace(loads=(waves,), command=(1.0,), excitation=(1.0,))
        ends.append(simulate(run).end)
    assert ends[0] == pytest.approx(ends[1], rel=1e-12)


def test_a_rotor_on_a_locked_clutch_swings_on_its_shaft():
    stiffness = 40.0
    device = with_shaft(Testbed(0.1), 0, 0.02, stiffness)
    run = Scenario("shaft", device, (always_on(50.0, 60.0),), (0.2, 0.2), (0.0, 0.0), 1.0)
    found = simulate(run.replace(command=(1.0,), excitation=(1.0,)))
    assert found.mode[-1, 0] == 0
    # The clutch's side stays where it is, at 0; the rotor swings on the wound-up shaft.
    assert found.end[0] == pytest.approx(0.2 * cos(sqrt(stiffness / 0.1)), rel=1e-8)
    balance = energy_balance(found)
    assert balance.residual < 1e-8 * balance.stored_start


@pytest.mark.parametrize("extend", [with_shaft, with_mount], ids=lambda f: f.__name__)
def test_what_a_damped_shaft_takes_is_in_the_energy_budget(extend):
    device = extend(SensorTestbed(0.1, 0.03, 8.0, 0.05), 0, 0.02, 40.0, 0.3)
    assert check_device(device) == []
    waves = Waves(((0, 1.5, 6.0, 0.0),))
    run = Scenario("damped", device, (always_on(0.6, 0.7),), (0.0,) * 3, (2.0, 0, 0), 1.0)
    found = simulate(run.replace(loads=(waves,), command=(1.0,), excitation=(1.0,)))
    balance = energy_balance(found)
    assert balance.relative < 1e-8
    assert balance.work_effects < -1e-3  # what the dampers take


def test_drag_beside_a_clutch_that_is_off_stops_the_rotor():
    device = with_drag(Testbed(0.1), 0)
    run = Scenario("drag", device, (Clutch(Coulomb(1, 1)), always_on(0.5, 0.5)), (0,), (2.0,), 1.0)
    found = simulate(run.replace(command=(0.0, 1.0), excitation=(0.0, 1.0)))
    assert [(e.kind, e.clutches) for e in found.events[1:]] == [("slip stop", (2,))]
    assert found.events[1].t == pytest.approx(0.1 * 2.0 / 0.5, rel=1e-12)


def test_pters_fourth_clutch_behind_a_gear_with_play_holds_only_when_the_play_is_taken_up():
    device = with_shaft(PTER, 3, 0.05, name="gear")
    gear = Backlash(coordinate=2, gap=0.02, stiffness=2e3, restitution=0.5)
    locked = (*(Clutch(Coulomb(1.0, 1.0)) for _ in range(3)), always_on(50.0, 60.0))
    push = Ramp(0.0, ((0.0, 30.0), (9.0, 30.0)))
    run = Scenario("gear", device, locked, (0.2, 0.1, 0.0), (0.0, 0.0, 0.0), 0.6, loads=(push,))
    found = simulate(
        run.replace(effects=(gear,), command=(0, 0, 0, 1.0), excitation=(0, 0, 0, 1.0))
    )
    assert found.status == "finished", found.message
    seen = sample(found, np.linspace(0.0, 0.6, 300))
    assert (seen.mode[:, 3] == 0).all()
    inside = abs(seen.q[:, 2]) < 0.01
    # Without contact the locked clutch carries nothing but its own side's zero acceleration.
    assert inside.any()
    assert (~inside).any()
    assert abs(seen.tau[inside, 3]).max() < 1e-9
    assert abs(seen.tau[~inside, 3]).max() > 1.0
    assert energy_balance(found, seen).relative < 1e-8
