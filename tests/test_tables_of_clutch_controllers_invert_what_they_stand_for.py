"""Look-up tables: the piecewise one against numpy.interp, the model's inverse against the model."""

import numpy as np
import pytest
from pter_control import Instants

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.desired_torque import DesiredTorque
from simpter_hybrid.controllers.inverse_model import InverseModel
from simpter_hybrid.controllers.piecewise_table import PiecewiseTable
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.laws import LBF_IN, TestbedTorque
from simpter_hybrid.scenario import Scenario

POINTS = ((0.0, 0.0), (10.0, 3.0), (30.0, 5.0), (80.0, 10.0))


def command(table, torque, speed=0.0):
    run = Scenario(
        "test", Testbed(1.0), (Clutch(TestbedTorque()),), (0.0,), (0.0,), 1.0,
        controllers=((DesiredTorque(torque), 1), (table, 1)), period=0.1,
    )  # fmt: skip
    return Instants(run)((0.0,), (speed,))[0][0]


@pytest.mark.parametrize("torque", [0.0, 4.0, 10.0, 29.0, 55.0, 80.0, 500.0])
def test_piecewise(torque):
    right = np.interp(torque, *zip(*POINTS, strict=True))
    assert command(PiecewiseTable(POINTS), torque) == pytest.approx(right, rel=1e-14)


@pytest.mark.parametrize(
    ("points", "said"),
    [
        (((0.0, 0.0),), "got 1, at least two"),
        (((0.0, 0.0), (0.0, 1.0)), "rising torques"),
        (((0.0, 8.0), (1.0, 9.0)), r"8 V; it has to be \(0, 0\)"),
        (((1.0, 0.0), (2.0, 9.0)), r"1 N m \(or N\), 0 V; it has to be \(0, 0\)"),
        (((0.0, 0.0), (1.0, 8.0), (2.0, 7.0)), "7 V follows 8 V"),
    ],
)
def test_points_must_rise(points, said):
    with pytest.raises(ValueError, match="points: .*" + said):
        PiecewiseTable(points)


@pytest.mark.parametrize("torque", [5.0, 150.0, 600.0])
@pytest.mark.parametrize("speed", [-1.5, 0.0, 0.4])
def test_inverse_model(torque, speed):
    law = TestbedTorque()
    own = law.parameters()
    volts = command(InverseModel(), torque * LBF_IN, speed)
    arguments = [own[k] for k in ("scale", "slope", "offset", "a", "b", "c")]
    given = law.slip_torque(abs(speed), volts, *arguments)
    assert given == pytest.approx(torque * LBF_IN, rel=1e-12)
