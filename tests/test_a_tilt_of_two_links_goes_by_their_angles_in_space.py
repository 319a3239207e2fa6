"""A forearm's weight goes by the sum of both angles where the second is relative to the first."""

import math
from dataclasses import replace

import numpy as np
import pytest
from two_joints import declared_joints

from simpter_hybrid.device import Device
from simpter_hybrid.identification.tip.joint_candidates import joint_candidates
from simpter_hybrid.loads.link_weights import LinkWeights
from simpter_hybrid.measuring.over_poses import over_poses

OFF = 0.06
POSES = np.random.default_rng(1).uniform(-3.0, 3.0, (20, 2))


class _Links(Device):
    """As much of two links as is asked for, with angles of some kind."""

    coordinates = surfaces = ("first", "second")


class InSpace(_Links):
    """Both angles from the vertical."""

    @staticmethod
    def mass_matrix(q, p, out):
        out[0], out[1], out[2], out[3] = 3.0, math.cos(q[0] - q[1]), math.cos(q[0] - q[1]), 1.0


class PanAndTilt(_Links):
    """Upright axis and, on it, a level one."""

    @staticmethod
    def mass_matrix(q, p, out):
        out[0], out[1], out[2], out[3] = 3.0 + math.cos(q[1]), 0.0, 0.0, 1.0


def _tilt(device=None):
    declared = declared_joints()
    declared = declared if device is None else replace(declared, device=device)
    made = joint_candidates(declared, (0.1, 0.2), 1.0, 2.0, (1.0, 1.0), (), (0.5, 2.0))
    return next(c for c in made if c.name == "tilt")


def test_it_is_what_another_direction_of_gravity_does():
    device = declared_joints().device
    here = over_poses(device, "conservative_force", POSES, 2)
    turned = over_poses(device, "conservative_force", POSES + np.array([OFF, 0.0]), 2)
    g, far = device.gravity, device.mass_2 * device.centre_2
    near = device.mass_1 * device.centre_1 + device.mass_2 * device.length_1
    for moments, q in zip(turned - here, POSES, strict=True):
        total = np.zeros(2)
        sizes = [-g * x * k for x in (near, far) for k in (np.sin(OFF), np.cos(OFF) - 1.0)]
        LinkWeights.force(q, total, *sizes, 1.0)
        assert total == pytest.approx(moments)


def test_it_is_asked_of_relative_angles_that_no_weight_turns_alone():
    weightless = replace(declared_joints().device, gravity=0.0)
    assert isinstance(_tilt(weightless).load, LinkWeights)
    assert _tilt().load is None
    for other in (InSpace(), PanAndTilt()):
        assert _tilt(other).load is None
        assert [e.coordinate for e in _tilt(other).effects()] == [0, 1]
