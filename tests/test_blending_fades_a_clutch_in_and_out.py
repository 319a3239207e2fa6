"""Weight 0 to 1 within ``apply``, 1 to 0 within ``release``; the last torque fades out."""

import pytest
from pter_control import Instants

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.blending import Blending
from simpter_hybrid.controllers.desired_torque import DesiredTorque
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.laws import TestbedTorque
from simpter_hybrid.scenario import Scenario


def faded(apply, release, wanted):
    """Torques handed on at 0, 0.1 ... s when the selector wants ``wanted`` in turn."""
    run = Scenario(
        "test", Testbed(1.0), (Clutch(TestbedTorque()),), (0.0,), (0.0,), 1.0,
        controllers=((DesiredTorque(0.0), 1), (Blending(apply, release), 1)), period=0.1,
    )  # fmt: skip
    at = Instants(run)
    mean = run.parameter_names().index("controller.1.mean")
    out = []
    for k, torque in enumerate(wanted):
        at.md.p[mean] = torque
        out.append(at((0.0,), (0.0,), 0.1 * k)[1][0])
    return out


def test_applied_in_four_steps_and_released_in_two():
    found = faded(0.4, 0.2, [0, 8, 8, 8, 8, 8, 0, 0, 0])
    # Multiples of 0.1 s carry rounding.
    assert found == pytest.approx([0, 2, 4, 6, 8, 8, 4, 0, 0], abs=1e-12)


def test_zero_durations_pass_everything():
    assert faded(0.0, 0.0, [0, 8, 3, 0, 5]) == [0, 8, 3, 0, 5]


def test_changes_while_applied_pass():
    assert faded(0.1, 0.1, [0, 8, 3, 5])[2:] == pytest.approx([3, 5])
