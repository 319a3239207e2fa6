"""Every kind of mistake in a device is named; every shipped device is sound."""

import math

import pytest
from devices_for_tests import Arm

from simpter_hybrid.device_check import check_device
from simpter_hybrid.devices.belt_and_mass import BeltAndMass
from simpter_hybrid.devices.force_feedback_mouse import ForceFeedbackMouse
from simpter_hybrid.devices.one_axis import LinearAxis, OneAxis
from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.devices.shaft_pair import ShaftPair
from simpter_hybrid.devices.testbed import SensorTestbed, Testbed
from simpter_hybrid.devices.two_link import TwoLink

SOUND = [
    Testbed(1.0), SensorTestbed(1.0, 0.1, 100.0, 0.2), Pter(33.0, 10.0, -1.3, 0.9, 0.6), Arm(),
    PlanarArm(), TwoLink(0.5, 0.6, 0.2, 0.2, 0.25, 0.03, 0.05), OneAxis(0.1, 2.0, 0.3),
    LinearAxis(3.0, 2.0), ForceFeedbackMouse(), ShaftPair(0.1, 0.2), BeltAndMass(1.0, 4.0),
]  # fmt: skip


@pytest.mark.parametrize("device", SOUND, ids=lambda d: type(d).__name__)
def test_a_sound_device_has_no_findings(device):
    assert check_device(device) == []


class Skew(Arm):
    @staticmethod
    def mass_matrix(q, p, out):
        Arm.mass_matrix(q, p, out)
        out[1] += 0.01


class Negative(Arm):
    @staticmethod
    def mass_matrix(q, p, out):
        Arm.mass_matrix(q, p, out)
        out[8] = -0.1


class WrongSign(Arm):
    @staticmethod
    def velocity_terms(q, qd, p, out):
        Arm.velocity_terms(q, qd, p, out)
        out[1] = -out[1]


class Damped(Arm):
    @staticmethod
    def velocity_terms(q, qd, p, out):
        Arm.velocity_terms(q, qd, p, out)
        out[2] += 0.1 * qd[2]


class Pumping(Arm):
    @staticmethod
    def damping_force(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0
        out[2] = 0.1 * qd[2]


class Transposed(Arm):
    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        Arm.clutch_map_rate(q, qd, p, out)
        out[3], out[4] = out[4], out[3]


class Constant(Arm):
    constant_clutch_map = True


class Short(Arm):
    @staticmethod
    def clutch_map(q, p, out):
        for i in range(14):
            out[i] = 1.0


class Long(Arm):
    @staticmethod
    def velocity_terms(q, qd, p, out):
        for i in range(4):
            out[i] = 0.0


class Uphill(OneAxis):
    @staticmethod
    def conservative_force(q, p, out):
        out[0] = p[1] * math.sin(q[0] - p[2])


class Renamed(Arm):
    @staticmethod
    def mass_matrix(x, p, out):
        Arm.mass_matrix(x, p, out)


@pytest.mark.parametrize(
    ("device", "array", "what"),
    [
        (Skew(), "mass_matrix", "symmetric"),
        (Negative(), "mass_matrix", "positive definite"),
        (WrongSign(), "velocity_terms", "does not belong"),
        (Damped(), "velocity_terms", "odd in the speeds"),
        (Pumping(), "damping_force", "gives energy"),
        (Transposed(), "clutch_map_rate", "not the rate"),
        (Constant(), "clutch_map", "constant_clutch_map"),
        (Short(), "clutch_map", "[14]"),
        (Long(), "velocity_terms", "beyond"),
        (Uphill(0.1, 2.0), "conservative_force", "-dU/dq"),
        (Renamed(), "mass_matrix", "arguments"),
    ],
    ids=lambda x: type(x).__name__ if not isinstance(x, str) else "",
)
def test_a_mistake_is_found_in_its_array(device, array, what):
    found = check_device(device)
    assert array in {f.array for f in found}
    assert any(what in str(f) for f in found if f.array == array)
