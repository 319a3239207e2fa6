"""A device's functions may change what they wrote, as numbers allow and shared arrays do not."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.sweeps.tip_motion import tip_motion

Q = np.array([[1.0, 0.3], [1.1, 0.5], [1.2, 0.8]])


def _jacobian(q, p, out):
    c, s = math.cos(q[1]), math.sin(q[1])
    out[0], out[1], out[2], out[3] = c, -q[0] * s, s, q[0] * c


def _rate(q, qd, p, out):
    out[0] = out[1] = 0.0


def _in_place(q, p, out):
    out[0] = q[0]
    out[1] = q[0]
    out[0] *= math.cos(q[1])
    out[1] *= math.sin(q[1])


def _handed_on(q, p, out):
    way = q[0] * math.cos(q[1])
    out[0] = way
    way += q[0] * (math.sin(q[1]) - math.cos(q[1]))
    out[1] = way


@pytest.mark.parametrize("tip", [_in_place, _handed_on])
def test_at_every_instant(tip):
    functions = {"tip": tip, "tip_jacobian": _jacobian, "tip_jacobian_rate": _rate}
    device = SimpleNamespace(functions=lambda: functions)
    scenario = SimpleNamespace(device=device, parameter_values=lambda: [])
    point, _ = tip_motion(scenario, Q.copy(), np.full((3, 2), 0.2), np.zeros((3, 2)))
    r, angle = Q.T
    assert point == pytest.approx(np.column_stack([r * np.cos(angle), r * np.sin(angle)]))
