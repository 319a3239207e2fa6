"""Passivity: desired torques are magnitudes against the slip, commands lie in their range."""

import numpy as np
import pytest
from pter_control import INCH, LBF, LINE, Instants, scenario

from simpter_hybrid.controllers.blending import Blending
from simpter_hybrid.controllers.gomes_translator import GomesImpedanceToLine
from simpter_hybrid.controllers.gomes_velocity import GomesVelocityController
from simpter_hybrid.controllers.impedance import ImpedanceToLine
from simpter_hybrid.controllers.impedance_circle import ImpedanceToCircle
from simpter_hybrid.controllers.integral_feedback import IntegralFeedback
from simpter_hybrid.controllers.inverse_model import InverseModel
from simpter_hybrid.controllers.lookup import LookupTable
from simpter_hybrid.controllers.piecewise_table import PiecewiseTable
from simpter_hybrid.controllers.torque_feedback import TorqueFeedback
from simpter_hybrid.controllers.velocity import VelocityController
from simpter_hybrid.laws import LBF_IN
from simpter_hybrid.loads.operator import Operator

SPRING = {"stiffness": 32 * LBF / INCH, "damping": 0.7 * LBF / INCH}
STEER = {"gain": 4e4 * LBF_IN * INCH, **LINE, "lock_torque": 600 * LBF_IN}
CENTRE = {"x": 0.0, "y": 0.0, "radius": 24 * INCH}
SELECTORS = [
    ImpedanceToLine(**SPRING, **LINE),
    GomesImpedanceToLine(**SPRING, **LINE),
    ImpedanceToCircle(**SPRING, **CENTRE),
    VelocityController(INCH, **STEER),
    GomesVelocityController(**STEER),
]
TABLES = [
    LookupTable(600 * LBF_IN),
    PiecewiseTable(((0.0, 0.0), (20.0, 4.0), (70.0, 10.0))),
    InverseModel(),
]
AFTER = [(), (TorqueFeedback(0.16 / LBF_IN),), (IntegralFeedback(1.0 / LBF_IN),)]


@pytest.mark.parametrize("selector", SELECTORS, ids=lambda c: type(c).__name__)
@pytest.mark.parametrize("table", TABLES, ids=lambda c: type(c).__name__)
def test_passivity(selector, table):
    rng = np.random.default_rng(7)
    load = Operator(7 * LBF, np.pi)
    runs = [scenario(selector, Blending(0.1, 0.1), table, *after, loads=(load,)) for after in AFTER]
    for at in [Instants(run) for run in runs]:
        for k in range(60):
            q = np.array([0.731, 1.583]) + rng.normal(size=2) * 0.1
            qd = rng.normal(size=2)
            tau = rng.normal(size=4) * 30.0
            commands, desired = at(q, qd, 0.01 * k, tau)
            # A clutch acts against its slip; a negative magnitude would ask it to push.
            assert min(desired[:4]) >= 0.0
            assert min(commands) >= 0.0
            assert max(commands) <= 10.0
