"""Equations (47)-(53) against NumPy's linear algebra, at random states."""

import numpy as np
from pter_control import INCH, LBF, LINE, PTER, Instants, scenario, tip_of

from simpter_hybrid.controllers.gomes_velocity import GomesVelocityController
from simpter_hybrid.controllers.velocity import VelocityController
from simpter_hybrid.laws import LBF_IN
from simpter_hybrid.loads.operator import Operator

ROWS = np.array([[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]])
GAIN, LOCK, KV = 4e4 * LBF_IN * INCH, 600 * LBF_IN, 1.0 * INCH


def expected(q, qd, force, heading_of):
    """Desired torques [N m] by the text of 5.5.1, for the path y = 24 in."""
    t1, t2 = q
    jacobian = np.array(  # equation (9)
        [
            [-PTER.l_a * np.sin(t1), -PTER.l_d * np.cos(t2)],
            [PTER.l_a * np.cos(t1), -PTER.l_d * np.sin(t2)],
        ]
    )
    velocity = jacobian @ qd
    distance = tip_of(q)[1] - 24 * INCH
    theta = heading_of(distance)
    forward = np.sign(velocity[0])
    wanted = np.array([np.cos(theta) * forward, -np.sin(theta)])
    pushes = [np.linalg.solve(jacobian.T, -np.sign(row @ qd) * row) for row in ROWS]
    out = np.zeros(4)
    candidates = [i for i, f in enumerate(pushes) if f[1] * np.sign(distance) < 0]
    if candidates:
        best = min(candidates, key=lambda i: between(pushes[i], wanted))
        out[best] = GAIN * abs(pushes[best][1]) * between(velocity, wanted)
    elif force[1] * distance > 0:
        out[:2] = LOCK
    return out


def between(a, b):
    return np.arccos(np.clip(a @ b / np.linalg.norm(a) / np.linalg.norm(b), -1.0, 1.0))


def printed(distance):
    return np.sign(distance) * min(np.arcsin(min(abs(distance) / KV, 1.0)), np.pi / 4)


def gomes(distance):
    return np.sign(distance) * np.pi / 4


def compare(controller, heading_of):
    rng = np.random.default_rng(53)
    seen = set()
    for _ in range(60):
        push = rng.normal(size=2) * 5 * LBF
        load = Operator(float(np.hypot(*push)), float(np.arctan2(push[1], push[0])))
        q = np.array([0.731, 1.583]) + rng.normal(size=2) * 0.01
        qd = rng.normal(size=2)
        _, desired = Instants(scenario(controller, loads=(load,)))(q, qd)
        right = expected(q, qd, push, heading_of)
        # Angles near 0 and pi come from arccos, which loses half the digits there.
        np.testing.assert_allclose(desired[:4], right, rtol=1e-6, atol=1e-9)
        seen.add(tuple(np.flatnonzero(right)))
    assert {(0,), (1,), (2,), (3,)} <= seen


def test_the_thesis_heading():
    compare(VelocityController(KV, GAIN, **LINE, lock_torque=LOCK), printed)


def test_gomes_heading_is_45_degrees():
    compare(GomesVelocityController(GAIN, **LINE, lock_torque=LOCK), gomes)
