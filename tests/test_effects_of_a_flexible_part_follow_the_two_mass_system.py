"""An elastic part: a force pushes the centre of both masses and sets them swinging about it."""

from math import cos, exp, pi, sin, sqrt

import numpy as np
import pytest
from devices_for_tests import Coulomb, Ramp

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.flexible_mode import FlexibleMode
from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

#: Inertia of all and of the part [kg m^2], speed at the start, force, duration [s].
J, PART, SPEED, FORCE, T = 0.3, 0.1, 2.0, 0.7, 1.3
FREQUENCY = 3.0
#: Solver tolerance 1e-10 a step, some hundred steps.
CLOSE = 1e-8


def pushed(force: float, damping: float):
    effect = FlexibleMode(coordinate=0, mass=PART, frequency=FREQUENCY, damping=damping)
    loads = (Ramp(0.0, ((0.0, force), (9.0, force))),)
    clutch = Clutch(Coulomb(1.0, 1.0))
    return simulate(
        Scenario(
            "pushed", Testbed(J), (clutch,), (0.0,), (SPEED,), T, loads=loads, effects=(effect,)
        )
    )


@pytest.mark.parametrize("damping", [0.0, 0.05])
def test_a_force_moves_the_centre_and_sets_both_swinging(damping):
    run = pushed(FORCE, damping)
    rest = J - PART
    # Stretch: r'' + 2 d r' + w^2 r = -F / rest, from 0.
    square = (2 * pi * FREQUENCY) ** 2 * J / rest
    decay = damping * 2 * pi * FREQUENCY * J / rest
    swing = sqrt(square - decay**2)
    fading = exp(-decay * T)
    pace = -FORCE / rest / swing * fading * sin(swing * T)
    swung = cos(swing * T) + decay / swing * sin(swing * T)
    stretch = -FORCE / rest / square * (1 - fading * swung)
    centre, speed = SPEED * T + 0.5 * FORCE / J * T**2, SPEED + FORCE / J * T
    angle = centre - PART / J * stretch
    assert run.end[0] == pytest.approx(angle, rel=CLOSE)
    assert run.end[1] == pytest.approx(speed - PART / J * pace, rel=CLOSE)


def test_what_is_pushed_by_nothing_moves_on_together():
    assert pushed(0.0, 0.05).end[:2] == pytest.approx([SPEED * T, SPEED], rel=CLOSE)


def test_a_part_goes_on_beside_the_coordinate_where_a_replay_sets_its_motion_anew():
    pytest.importorskip("llvmlite", reason="replays run in the compiled engine (extra compiled)")
    from simpter_hybrid.on_grid import simulate_on_grid

    # Mostly part, as stiff as a rod: with the speed of the window before it would take over.
    effect = FlexibleMode(coordinate=0, mass=0.99 * J, frequency=50.0, damping=1.0)
    clutch = Clutch(Coulomb(0.0, 0.0))
    scenario = Scenario("set anew", Testbed(J), (clutch,), (0.0,), (SPEED,), T, effects=(effect,))
    anew = (np.array([0.5]), np.array([[0.0]]), np.array([[2.0 * SPEED]]))
    told = simulate_on_grid(scenario, np.array([0.4, 0.6, 1.2]), anew)
    assert told.qd[:, 0] == pytest.approx([SPEED, 2.0 * SPEED, 2.0 * SPEED], rel=CLOSE)
