"""A function's text is put into the model: names of its file are told, with what to write."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controller import Controller
from simpter_hybrid.device_check import check_device
from simpter_hybrid.devices.one_axis import OneAxis
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario

G = 9.81


def pull(q):
    return G * math.sin(q[0])


def far(q):
    return math.hypot(q[0], 1.0)


@dataclass(frozen=True)
class Pendulum(OneAxis):
    """A pendulum with a force of its own."""

    uses: ClassVar[tuple] = (far,)

    @staticmethod
    def conservative_force(q, p, out):
        out[0] = -p[1] * math.sin(q[0]) + 0.0 * far(q) * G


@dataclass(frozen=True)
class Helped(Controller):
    """A controller with a helper, and a helper's constant."""

    uses: ClassVar[tuple] = (pull,)

    @staticmethod
    def step(q, held):
        held[0] = abs(pull(q)) + np.sign(q[0])


def test_a_constant_of_the_file_is_no_part_of_a_device():
    (found,) = check_device(Pendulum(inertia=1.0))
    assert found.array == "conservative_force"
    assert "uses G" in found.what
    assert found.value == "G = 9.81"
    assert "parameter" in found.right


def test_a_helper_is_to_be_named_in_uses(monkeypatch):
    monkeypatch.setattr(Pendulum, "uses", ())
    found = check_device(Pendulum(inertia=1.0))
    assert any("uses: ClassVar[tuple] = (far,)" in each.right for each in found)


def test_a_module_is_told_before_the_run():
    stages, clutch = ((Helped(), 1),), Clutch(torque=LinearTorque(rated=1.0))
    scenario = Scenario(
        "x", OneAxis(inertia=1.0), (clutch,), (0.1,), (0.0,), 1.0, controllers=stages, period=0.1
    )
    with pytest.raises(InvalidInput, match=r"Helped\.step .* np, .*the module numpy"):
        validate(scenario)
