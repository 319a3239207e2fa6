"""Held inputs of drives lie side by side, whichever stage comes first; a missing one is said."""

import pytest

from simpter_hybrid import compiled, engine
from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.axis_servo import PositionServo
from simpter_hybrid.controllers.drive_delay import DriveDelay
from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.loads.drive import ForceDrive
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario


def servo(coordinate, volts):
    return PositionServo(((0.0, volts),), 1.0, coordinate=coordinate)


def arm(stages, drives):
    device = PlanarArm()
    return Scenario(
        "arm", device, (Clutch(LinearTorque(1.0)),) * device.m, (0.0,) * 3, (0.0,) * 3, 0.001,
        tuple(ForceDrive(1.0, coordinate=j) for j in drives), tuple((s, 1) for s in stages),
        period=0.01,
    )  # fmt: skip


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
@pytest.mark.parametrize("order", [(2, 0), (0, 2)])
def test_the_third_drive_is_none_of_the_others(simulate, order):
    told = {0: 3.0, 2: 7.0}
    run = simulate(arm([servo(float(j), told[j]) for j in order], (0.0, 2.0)))
    m = run.scenario.device.m
    assert list(run.held[-1][m:]) == [3.0, 0.0, 7.0, 0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("stages", "place"),
    [
        ([servo(0.0, 1.0)], r"loads\.0\.coordinate"),
        ([servo(0.0, 1.0), DriveDelay(coordinate=2.0)], r"stages\.1\.coordinate"),
    ],
)
def test_a_drive_that_no_stage_writes_is_refused(stages, place):
    with pytest.raises(InvalidInput, match=place + ": no stage holds drive_3"):
        validate(arm(stages, (2.0,)))
