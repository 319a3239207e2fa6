"""A course that ends in motion: the loop that holds it takes the speed away at its last place."""

from math import exp

import pytest
from devices_for_tests import Coulomb

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.prescribed_motion import PrescribedMotion
from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

HOLD, SPEED, PLACE = 50.0, 2.0, 0.4


def test_a_speed_left_at_the_end_goes_as_in_a_critically_damped_loop():
    points = ((0.0, 0.0), (0.1, 0.2), (0.2, PLACE))
    # Nothing else acts: a bulk far beyond the rotor is enough, a larger one costs steps.
    moved = PrescribedMotion(coordinate=0, points=points, hold=HOLD, bulk=1.0)
    late = 0.03
    run = simulate(
        Scenario(
            "ends", Testbed(1e-9), (Clutch(Coulomb(1, 1)),), (0.0,), (SPEED,), 0.2 + late,
            effects=(moved,), max_step=0.01,
        )
    )  # fmt: skip
    assert run.status == "finished", run.message
    # x'' + 2 hold x' + hold^2 x = 0 from 0 at SPEED; solver tolerance.
    away = SPEED * late * exp(-HOLD * late)
    assert run.end[0] == pytest.approx(PLACE + away, abs=1e-7)
    assert run.end[1] == pytest.approx(SPEED * (1.0 - HOLD * late) * exp(-HOLD * late), abs=1e-6)
