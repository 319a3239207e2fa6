"""Where the clutch map turns with the pose, other speeds become the dependent ones as it goes.

A body on a held cable goes round; a three-link arm's tip slides along a wall that it sticks to.
The references keep all coordinates: a pendulum's angle, and a constrained system of full order.
"""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest
from devices_for_tests import Arm, always_on
from scipy.integrate import solve_ivp

from simpter_hybrid.compiled import simulate as compiled
from simpter_hybrid.device import Device
from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

ENGINES = pytest.mark.parametrize("run", [simulate, compiled], ids=["reference", "compiled"])
G = 9.81
#: Over 3 s a run's error is some hundred steps' tolerance of 1e-10.
CLOSE = 1e-8


@dataclass(frozen=True)
class Cable(Device):
    """A body of 1 kg on a braked cable from the origin."""

    coordinates: ClassVar[tuple[str, ...]] = ("x", "y")
    coordinate_dimensions: ClassVar[tuple[str, ...]] = ("length", "length")
    surfaces: ClassVar[tuple[str, ...]] = ("drum",)
    constant_clutch_map: ClassVar[bool] = False

    @staticmethod
    def mass_matrix(q, p, out):
        out[0], out[1], out[2], out[3] = 1.0, 0.0, 0.0, 1.0

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0], out[1] = 0.0, 0.0

    @staticmethod
    def clutch_map(q, p, out):
        length = math.sqrt(q[0] * q[0] + q[1] * q[1])
        out[0], out[1] = q[0] / length, q[1] / length

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        length = math.sqrt(q[0] * q[0] + q[1] * q[1])
        out_of = (q[0] * qd[0] + q[1] * qd[1]) / length
        out[0] = (qd[0] * qd[0] + qd[1] * qd[1] - out_of * out_of) / length

    @staticmethod
    def conservative_force(q, p, out):
        out[0], out[1] = 0.0, -9.81

    @staticmethod
    def potential_energy(q, p):
        return 9.81 * q[1]


def scenario(device, holds, q, qd):
    clutches = tuple(always_on(level, level) for level in holds)
    m = len(holds)
    return Scenario(
        "held", device, clutches, q, qd, 3.0, command=(1.0,) * m, excitation=(1.0,) * m,
        rtol=1e-10, atol=1e-12,
    )  # fmt: skip


@ENGINES
def test_a_body_on_a_held_cable_goes_round(run):
    found = run(scenario(Cable(), (500.0,), (0.0, -1.0), (8.0, 0.0)))
    told = solve_ivp(
        lambda t, y: [y[1], -G * math.sin(y[0])], (0.0, 3.0), [0.0, 8.0],
        method="DOP853", rtol=1e-12, atol=1e-12,
    ).y[:, -1]  # fmt: skip
    angle, rate = told
    s, c = math.sin(angle), math.cos(angle)
    assert found.status == "finished", found.message
    assert [e.kind for e in found.events] == ["start"]
    assert found.end[:4] == pytest.approx([s, -c, rate * c, rate * s], abs=CLOSE)


@ENGINES
def test_an_arm_slides_along_a_wall_that_its_tip_sticks_to(run):
    start, speeds = np.radians([10.0, 60.0, 80.0]), np.array([0.5, -1.0, 0.8])
    row = 3
    mapped = _array(Arm.clutch_map, start, 15).reshape(5, 3)[row]
    speeds -= mapped * (mapped @ speeds) / (mapped @ mapped)
    holds = [0.0] * 5
    holds[row] = 1e4
    found = run(scenario(Arm(), holds, tuple(start.tolist()), tuple(speeds.tolist())))

    def whole(t, y):
        q, qd = y[:3], y[3:]
        mass = _array(Arm.mass_matrix, q, 9).reshape(3, 3)
        terms, rate = np.zeros(3), np.zeros(5)
        Arm.velocity_terms(q, qd, _parameters(), terms)
        Arm.clutch_map_rate(q, qd, _parameters(), rate)
        one = _array(Arm.clutch_map, q, 15).reshape(5, 3)[row]
        free, turn = np.linalg.solve(mass, -terms), np.linalg.solve(mass, one)
        return [*qd, *(free - turn * (rate[row] + one @ free) / (one @ turn))]

    told = solve_ivp(
        whole, (0.0, 3.0), [*start, *speeds], method="DOP853", rtol=1e-12, atol=1e-12
    ).y[:, -1]
    assert found.status == "finished", found.message
    assert found.end[:6] == pytest.approx(told, abs=CLOSE)


def _parameters():
    return list(Arm().parameters().values())


def _array(function, q, size):
    out = np.zeros(size)
    function(q, _parameters(), out)
    return out
