"""Selectors of a path on a device whose clutch map is not PTER's, and on one they are not for."""

import numpy as np
import pytest
from pter_control import PTER, Instants

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.gomes_translator import GomesImpedanceToLine
from simpter_hybrid.controllers.gomes_velocity import GomesVelocityController
from simpter_hybrid.controllers.impedance import ImpedanceToLine
from simpter_hybrid.controllers.impedance_circle import ImpedanceToCircle
from simpter_hybrid.controllers.velocity import VelocityController
from simpter_hybrid.devices.extended import with_shaft
from simpter_hybrid.devices.force_feedback_mouse import ForceFeedbackMouse
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.loads.operator import Operator
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario

MOUSE = ForceFeedbackMouse()
LINE = {"x": 0.0, "y": 0.0, "angle": 0.0}
#: Of the line y = 0, also as a circle of 1 km.
SELECTORS = [
    ImpedanceToLine(200.0, 0.0, **LINE),
    GomesImpedanceToLine(200.0, 0.0, **LINE),
    ImpedanceToCircle(200.0, 0.0, 0.0, -1000.0, 1000.0),
    VelocityController(0.05, 20.0, **LINE, lock_torque=0.0),
    GomesVelocityController(20.0, **LINE, lock_torque=0.0),
]


def run_of(device, stage):
    n, m = device.n, device.m
    load = (Operator(1.0, 0.0),)
    clutches = (Clutch(LinearTorque(20.0)),) * m
    stages = ((stage, 1),)
    return Scenario("s", device, clutches, (0.5,) * n, (0.1,) * n, 1.0, load, stages, period=0.01)


@pytest.mark.parametrize("selector", SELECTORS, ids=lambda c: type(c).__name__)
def test_the_mouse_is_pulled_to_its_path(selector):
    rng, at = np.random.default_rng(3), Instants(run_of(MOUSE, selector))
    rows = np.zeros(8)
    MOUSE.clutch_map((), (), rows)
    rows, pulls = rows.reshape(4, 2), []
    for k in range(50):
        q, qd = rng.normal(size=2) * 0.02, rng.normal(size=2)
        _, desired = at(q, qd, 0.01 * k)
        force = rows.T @ (-np.sign(rows @ qd) * desired[:4])
        pulls.append(-np.sign(q[1]) * force[1])
    assert min(pulls) > -1e-9
    assert max(pulls) > 0.1


@pytest.mark.parametrize("selector", SELECTORS, ids=lambda c: type(c).__name__)
def test_a_third_coordinate_is_refused(selector):
    device = with_shaft(PTER, 0, 1.0, 1e3, 1.0)
    with pytest.raises(InvalidInput, match=rf"{type(selector).__name__} is for devices of 2 coord"):
        validate(run_of(device, selector))
