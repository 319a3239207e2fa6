"""DriveDelay from rest against the momentum of a mass that is pushed from the first sample on."""

import pytest
from devices_for_tests import Coulomb

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.axis_servo import PositionServo
from simpter_hybrid.controllers.drive_delay import DriveDelay
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.engine import simulate
from simpter_hybrid.loads.drive import ForceDrive
from simpter_hybrid.scenario import Scenario

#: Inertia [kg m^2], limit of the servo [V], torque a volt [N m/V], duration and sample [s].
J, U, K, T, SAMPLE = 0.3, 2.0, 1.5, 1.2, 0.1


def speed(delay, from_rest):
    """At the end of a run whose servo pushes with its limit all the time [rad/s]."""
    servo = PositionServo(((0.0, 1e6), (T, 1e6)), 1.0, limit=U)
    stages = ((servo, 1), (DriveDelay(delay, from_rest=from_rest), 1))
    return simulate(Scenario(
        "pushed", Testbed(J), (Clutch(Coulomb(1.0, 1.0)),), (0.0,), (0.0,), T, (ForceDrive(K),),
        stages, period=SAMPLE,
    )).end[1]  # fmt: skip


@pytest.mark.parametrize("delay", [0.0, 0.03, 0.1, 0.33, 1.2])
def test_it_pushes_so_much_later(delay):
    assert speed(delay, SAMPLE) == pytest.approx(K * U / J * (T - delay), abs=1e-8)


def test_told_for_long_it_pushes_from_the_start():
    assert speed(0.33, 0.0) == pytest.approx(K * U / J * T, abs=1e-8)
