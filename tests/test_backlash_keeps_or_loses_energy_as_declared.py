"""A rotor that rattles between two ends: speeds, instants and energies by hand."""

from math import pi, sqrt

import numpy as np
import pytest
from devices_for_tests import Coulomb

from simpter_hybrid import compiled
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.backlash import Backlash
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.on_grid import simulate_on_grid
from simpter_hybrid.scenario import Scenario

INERTIA, GAP, STIFFNESS, SPEED = 0.02, 0.1, 5e3, 1.0


def scenario(contact, q, speed, t_end):
    run = Scenario("gap", Testbed(INERTIA), (Clutch(Coulomb(1, 1)),), (q,), (speed,), t_end)
    return run.replace(effects=(contact,))


def rattle(restitution, t_end):
    contact = Backlash(coordinate=0, gap=GAP, stiffness=STIFFNESS, restitution=restitution)
    found = simulate(scenario(contact, 0.0, SPEED, t_end))
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


@pytest.mark.parametrize("engine", [simulate, compiled.simulate])
def test_a_play_far_narrower_than_a_step_still_loses_the_share_at_each_impact(engine):
    gap, restitution = 1e-5, 0.5
    contact = Backlash(coordinate=0, gap=gap, stiffness=STIFFNESS, restitution=restitution)
    quarter = 0.5 * pi * sqrt(INERTIA / STIFFNESS)
    # Two impacts: a quarter period in, `restitution` times that out to where the contact lets go,
    # from there without force to where it began; flights through the play ever slower.
    let_go = (1.0 / restitution - restitution) * sqrt(INERTIA / STIFFNESS)
    flights = gap / SPEED * (0.5 + 1.0 / restitution + 1.0 / restitution**2)
    third = flights + 2.0 * (quarter * (1.0 + restitution) + let_go)
    found = engine(scenario(contact, 0.0, SPEED, third + quarter))
    # Deepest in the third, whose speed has lost the share twice.
    depth = restitution**2 * SPEED * sqrt(INERTIA / STIFFNESS)
    assert found.end[0] == pytest.approx(0.5 * gap + depth, rel=1e-6)
    assert found.end[1] == pytest.approx(0.0, abs=1e-6 * SPEED)


@pytest.mark.parametrize("speed", [0.0, -SPEED, SPEED])
def test_a_run_that_starts_inside_a_contact_has_its_energy(speed):
    contact = Backlash(coordinate=0, gap=GAP, stiffness=STIFFNESS)
    depth = 0.01
    found = simulate(scenario(contact, 0.5 * GAP + depth, speed, 0.03))
    assert abs(found.end[0]) < 0.5 * GAP  # in flight
    free = sqrt(speed**2 + STIFFNESS / INERTIA * depth**2)
    assert abs(found.end[1]) == pytest.approx(free, rel=1e-8)


def test_a_run_restarted_out_of_its_contact_flies_free():
    contact = Backlash(coordinate=0, gap=GAP, stiffness=STIFFNESS, restitution=0.6)
    grid = np.array([0.0, 0.055, 0.1])
    where = (np.array([0.055]), np.array([[0.01]]), np.array([[0.1]]))
    found = simulate_on_grid(scenario(contact, 0.0, SPEED, 0.1), grid, where)
    assert found.q[1, 0] > 0.5 * GAP  # loading
    assert found.q[2, 0] == pytest.approx(0.01 + 0.1 * 0.045, rel=1e-9)
