"""At rest no clutch can push the tip: the operator's force decides between lock and release."""

import math

import pytest
from pter_control import INCH, LBF, LINE, Instants, scenario, tip_of

from simpter_hybrid.controllers.lookup import LookupTable
from simpter_hybrid.controllers.velocity import VelocityController
from simpter_hybrid.laws import LBF_IN
from simpter_hybrid.loads.operator import Operator

ABOVE = (0.74, 1.55)


@pytest.mark.parametrize(
    ("direction", "commands"),
    [(math.pi / 2, [10.0, 10.0, 0.0, 0.0]), (-math.pi / 2, [0.0] * 4), (0.0, [0.0] * 4)],
)
def test_fallback(direction, commands):
    assert tip_of(ABOVE)[1] > LINE["y"]
    selector = VelocityController(INCH, 1.0, **LINE, lock_torque=600 * LBF_IN)
    table = LookupTable(600 * LBF_IN)
    at = Instants(scenario(selector, table, loads=(Operator(5 * LBF, direction),)))
    found, _ = at(ABOVE, (0.0, 0.0))
    # cos(pi/2) is 6e-17: a push along the path has no outward part, one across it has all of it.
    assert found == pytest.approx(commands, abs=1e-12)
