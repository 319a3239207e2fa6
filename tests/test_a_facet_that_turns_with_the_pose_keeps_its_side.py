"""A redundantly stuck set whose clutch map turns breaks away at the instant of its closed form.

The margins of a facet belong to the two sides of its normal. Were the sides to change places at
some pose, a guard would jump there, and a breakaway a little earlier be located at the jump. And
where two facets are one in some pose, both go on as guards.
"""

import math
from dataclasses import dataclass

import numpy as np
import pytest
from devices_for_tests import Ramp, always_on
from scipy.optimize import brentq

from simpter_hybrid import compiled, engine
from simpter_hybrid.device import Device
from simpter_hybrid.kernel.linear import null_vector
from simpter_hybrid.scenario import Scenario

ENGINES = {"reference": engine.simulate, "compiled": compiled.simulate}


@dataclass(frozen=True)
class Turning(Device):
    """A mass in the plane on two slides at right angles and a third whose direction turns."""

    mass: float = 1.0

    coordinates = ("x", "y", "turn")
    surfaces = ("x", "y", "slanted")
    constant_clutch_map = False

    @staticmethod
    def mass_matrix(q, p, out):
        for i in range(9):
            out[i] = p[0] if i % 4 == 0 else 0.0

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = out[1] = out[2] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        for i in range(9):
            out[i] = 1.0 if i == 0 or i == 4 else 0.0
        out[6] = math.cos(q[2])
        out[7] = math.sin(q[2])

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = out[1] = 0.0
        out[2] = (-math.sin(q[2]) * qd[0] + math.cos(q[2]) * qd[1]) * qd[2]


def margin(t, start, load):
    """Least margin of the three facets, all breakaway torques being 1."""
    turn = start + t
    rows = np.array([[1.0, 0.0], [0.0, 1.0], [math.cos(turn), math.sin(turn)]])
    normals = np.column_stack([rows[:, 1], -rows[:, 0]])
    return min(np.abs(rows @ n).sum() - abs(load(t) @ n) for n in normals)


@pytest.mark.parametrize("simulate", ENGINES.values(), ids=list(ENGINES))
@pytest.mark.parametrize(
    ("flip", "side"),
    # Where the larger entry of the slanted row becomes the smaller, and where one passes zero.
    [(0.25 * math.pi, (-1.0, 1.0)), (0.0, (1.5, 1.0))],
)
@pytest.mark.parametrize("early", [1e-3, 1e-4])
def test_it_breaks_away_when_its_closed_form_does(simulate, flip, side, early):
    start = flip - 0.3
    slope = np.array([0.0, 2.0]) if side[0] > 1.0 else np.array([-2.0, 2.0])

    def load(t):
        return np.array(side) + slope * (t - 0.3 + early)

    true = brentq(margin, 0.2, 0.4, args=(start, load), xtol=1e-14)
    ramps = [(j, ((0.0, load(0.0)[j]), (1.0, load(1.0)[j]))) for j in range(2)]
    run = simulate(Scenario(
        "turning", Turning(), (always_on(0.8, 1.0),) * 3, (0.0, 0.0, start), (0.0, 0.0, 1.0), 0.4,
        loads=tuple(Ramp(float(j), points) for j, points in ramps),
        command=(1.0,) * 3, excitation=(1.0,) * 3,
    ))  # fmt: skip
    first = next(e for e in run.events if e.kind == "breakaway")
    assert first.t == pytest.approx(true, abs=1e-12)


def test_a_normal_is_on_the_side_of_the_cofactors():
    rng = np.random.default_rng(4)
    for r in (2, 3, 4):
        for _ in range(200):
            rows = rng.normal(size=(r - 1, r))
            found = np.zeros(r)
            assert null_vector(rows.ravel().copy(), r - 1, r, np.zeros(r, int), found) == 0
            cofactors = [(-1) ** j * np.linalg.det(np.delete(rows, j, 1)) for j in range(r)]
            # Determinants of at most three rows; nearly dependent ones are rare among so few.
            assert found @ cofactors == pytest.approx(np.abs(cofactors).max() * found @ found)
