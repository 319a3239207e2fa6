"""Python copies a slice, the compiled engine does not: a part that stores into one is refused."""

from dataclasses import dataclass

import pytest

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.controller import Controller
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.problems import InvalidInput

BAR = load("torque-bar-12v")


def raised(cell):
    cell[0] += 1.0


@dataclass(frozen=True)
class Named(Controller):
    memory = ("count",)

    @staticmethod
    def step(held, mem, mem_at):
        cell = mem[mem_at : mem_at + 1]
        cell[0] += 0.01
        held[0] = cell[0]


@dataclass(frozen=True)
class Nameless(Controller):
    @staticmethod
    def step(held):
        held[0:1][0] = 1.0


@dataclass(frozen=True)
class Handed(Controller):
    uses = (raised,)

    @staticmethod
    def step(held):
        cell = held[0:1]
        raised(cell)


@dataclass(frozen=True)
class Speeds(Controller):
    @staticmethod
    def step(qd):
        qd[0] = 0.0


@dataclass(frozen=True)
class Scratch(Controller):
    uses = (raised,)

    @staticmethod
    def step(s, qd, held):
        cell = s[0:1]
        cell[0] = qd[0]
        raised(cell)
        held[0] = max(min(cell[0], 1.0), 0.0)


def asked(stage):
    return BAR.replace(controllers=((stage, 1),), period=0.01)


@pytest.mark.parametrize(
    ("stage", "said"),
    [
        (Named(), r"Named\.step stores into cell, a slice of mem"),
        (Nameless(), r"Nameless\.step stores into held\[0:1\], a slice of held"),
        (Handed(), r"Handed\.step stores into cell, a slice of held"),
        (Speeds(), r"Speeds\.step stores into qd, a slice of the state"),
    ],
)
def test_refused(stage, said):
    with pytest.raises(InvalidInput, match=r"stages\.0: .*" + said):
        validate(asked(stage))


def test_scratch_may_be_sliced():
    validate(asked(Scratch()))
