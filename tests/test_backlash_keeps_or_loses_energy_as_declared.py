"""A rotor that rattles between two ends: speeds, instants and energies by hand."""

from math import pi, sqrt

import pytest
from devices_for_tests import Coulomb

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.backlash import Backlash
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.scenario import Scenario

INERTIA, GAP, STIFFNESS, SPEED = 0.02, 0.1, 5e3, 1.0


def rattle(restitution, t_end):
    contact = Backlash(coordinate=0, gap=GAP, stiffness=STIFFNESS, restitution=restitution)
    run = Scenario("gap", Testbed(INERTIA), (Clutch(Coulomb(1, 1)),), (0.0,), (SPEED,), t_end)
    found = simulate(run.replace(effects=(contact,)))
    assert found.status == "finished", found.message
    assert energy_balance(found).relative < 1e-8
    return found


def test_an_elastic_end_gives_all_the_speed_back_after_half_a_period():
    away = pi * sqrt(INERTIA / STIFFNESS)
    run = rattle(1.0, 0.5 * GAP / SPEED + away + GAP / SPEED)
    # Back through the whole gap: at the other end, at the same speed.
    assert run.end[0] == pytest.approx(-0.5 * GAP, abs=1e-9)
    assert run.end[1] == pytest.approx(-SPEED, rel=1e-9)


@pytest.mark.parametrize("restitution", [0.3, 0.7])
def test_every_impact_gives_back_the_declared_share_of_the_speed(restitution):
    run = rattle(restitution, 0.4)
    flights = [restitution**k for k in range(8)]
    speeds = {round(abs(float(run.state(t, "left")[1])), 9) for t in (0.02, 0.1)}
    assert speeds == {round(f, 9) for f in flights[:2]}
    # The loss is the work that the contacts have taken.
    lost = 0.5 * INERTIA * (SPEED**2 - run.state(0.1, "left")[1] ** 2)
    assert -run.state(0.1, "left")[-2] == pytest.approx(lost, rel=1e-8)
