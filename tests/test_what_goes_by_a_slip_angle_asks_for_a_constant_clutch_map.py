"""C q is what a clutch has slipped where C is constant; elsewhere an effect by it is refused."""

import re

import pytest
from devices_for_tests import always_on

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.effects.empirical_friction import EmpiricalByPosition
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario


def _arm(clutch: int) -> Scenario:
    return Scenario(
        "arm", PlanarArm(), (always_on(1.0, 1.0),) * 5, (0.0, 0.9, 1.4), (0.0,) * 3, 1.0,
        effects=(EmpiricalByPosition(clutch=clutch),),
    )  # fmt: skip


def test_an_arm_has_one_at_its_joints_and_none_at_its_tip():
    validate(_arm(1))
    told = re.escape("EmpiricalByPosition on clutch 4 (tip x)") + ".*base, elbow, wrist"
    with pytest.raises(InvalidInput, match=told):
        validate(_arm(3))
