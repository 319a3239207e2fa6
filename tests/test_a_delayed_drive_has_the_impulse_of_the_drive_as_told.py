"""DriveDelay against closed forms of a mass that a servo at its limit pushes to and fro."""

import pytest
from devices_for_tests import Coulomb

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.axis_servo import PositionServo
from simpter_hybrid.controllers.drive_delay import DriveDelay
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.engine import simulate
from simpter_hybrid.loads.drive import ForceDrive
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario

#: Inertia [kg m^2], limit of the servo [V], torque a volt [N m/V], duration and sample [s].
J, U, K, T, SAMPLE = 0.3, 2.0, 1.5, 1.2, 0.1
#: Told backward until then, forward after.
TURN = 0.5


def pushed(delay, sample=SAMPLE):
    """A mass that is told to turn round."""
    told = TURN - 0.5 * sample, TURN - 0.4 * sample
    points = ((0.0, -1e6), (told[0], -1e6), (told[1], 1e6), (T, 1e6))
    stages = ((PositionServo(points, 1.0, limit=U), 1), (DriveDelay(delay), 1))
    return Scenario(
        "pushed", Testbed(J), (Clutch(Coulomb(1.0, 1.0)),), (0.0,), (0.0,), T, (ForceDrive(K),),
        stages, period=sample,
    )  # fmt: skip


@pytest.mark.parametrize("delay", [0.0, 0.03, 0.1, 0.33, 0.6])
def test_the_mass_turns_so_much_later(delay):
    run = simulate(pushed(delay))
    # Only at the end of a sample have told and handed on the same impulse: T is one.
    expected = K * U / J * (T - 2.0 * (TURN + delay))
    assert run.end[1] == pytest.approx(expected, abs=1e-8)  # solver tolerance 1e-10 a step


def test_the_drive_is_kept_for_many_more_samples_than_the_delay():
    # 1200 samples, of which the last 60.5 are waited for: the kept ones are written over.
    run = simulate(pushed(0.0605, 1e-3))
    assert run.end[1] == pytest.approx(K * U / J * (T - 2.0 * (TURN + 0.0605)), abs=1e-6)


def test_before_the_start_the_first_drive_was_told():
    assert simulate(pushed(T)).end[1] == pytest.approx(-K * U / J * T, abs=1e-8)


def test_a_longer_delay_than_is_kept_is_refused():
    with pytest.raises(InvalidInput, match=r"beyond the past that is kept.*at most 6\.3 s"):
        validate(pushed(6.4))
