"""A controller's stage keeps to its commands, its memory and the state, and returns nothing."""

from dataclasses import dataclass
from typing import ClassVar

import pytest

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controller import Controller
from simpter_hybrid.devices.shaft_pair import ShaftPair
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario


class Counts(Controller):
    memory: ClassVar[tuple[str, ...]] = ("count",)

    @staticmethod
    def step(q, qd, held, mem, mem_at):
        mem[mem_at] += 1.0
        held[0] = abs(q[1]) + abs(qd[1])
        held[1] = mem[mem_at]


class FromOne(Controller):
    @staticmethod
    def step(held):
        held[1] = 4.0
        held[2] = 8.0


class Last(Controller):
    @staticmethod
    def step(held):
        held[-1] = 4.0


class NextCell(Counts):
    @staticmethod
    def step(mem, mem_at):
        mem[mem_at + 1] = 7.0


class NoCell(Controller):
    @staticmethod
    def step(mem, mem_at):
        mem[mem_at] = 1.0


class ThirdCoordinate(Controller):
    @staticmethod
    def step(q, held):
        held[0] = q[2]


@dataclass(frozen=True)
class Returns(Controller):
    @staticmethod
    def step(q):
        return [4.0, 4.0]


def checked(*stages):
    clutch = Clutch(torque=LinearTorque(rated=1.0))
    return Scenario(
        "x", ShaftPair(1.0, 2.0), (clutch, clutch), (0.0, 0.0), (0.0, 0.0), 1.0,
        controllers=tuple((stage, 1) for stage in stages), period=0.1,
    )  # fmt: skip


def test_what_is_its_own_may_be_used():
    validate(checked(Counts(), Counts()))


@pytest.mark.parametrize(
    ("stage", "said", "right"),
    [
        (FromOne(), r"held\[2\]", r"held\[0\] to held\[1\], numbered from 0: clutch, brake"),
        (Last(), r"held\[-1\]", r"held\[0\] to"),
        (NextCell(), r"mem\[mem_at \+ 1\]", r"mem\[mem_at \+ 0\]"),
        (NoCell(), r"mem\[mem_at \+ 0\]", r"memory = \("),
        (ThirdCoordinate(), r"q\[2\]", r"q\[0\] to q\[1\]"),
        (Returns(), "returns", r"held\[0\] = "),
    ],
    ids=lambda x: type(x).__name__,
)
def test_what_is_not_is_refused_with_what_would_be_right(stage, said, right):
    with pytest.raises(InvalidInput, match=rf"controller\.stages\.1.*{said}.*expected .*{right}"):
        validate(checked(Counts(), stage))
