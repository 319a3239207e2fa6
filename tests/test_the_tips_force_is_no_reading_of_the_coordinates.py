"""A force sensor in the handle reads the force itself, whatever stands before it measures."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest

import simpter_hybrid as sh
from simpter_hybrid import compiled, engine
from simpter_hybrid.checks.validation import validate
from simpter_hybrid.controller import Controller
from simpter_hybrid.controllers.measurement import Measurement
from simpter_hybrid.loads.tip_spring import TipDrag
from simpter_hybrid.problems import InvalidInput

ENGINES = {"reference": engine.simulate, "compiled": compiled.simulate}


@dataclass(frozen=True)
class Shown(Controller):
    """Holds the force that the sensor shows."""

    holds: ClassVar[tuple[str, ...]] = ("shown_x", "shown_y")

    @staticmethod
    def step(time, state, p, rec, s, held, at_shown_x, tip_force_now):
        push = s[8:12]
        tip_force_now(time, state, p, rec, held, s, push)
        held[at_shown_x] = push[0]
        held[at_shown_x + 1] = push[1]


@dataclass(frozen=True)
class ByCoordinates(Controller):
    """Hands on its coordinates, which are not all that a load may need."""

    @staticmethod
    def step(time, q, p, rec, s, held, tip_force_now):
        tip_force_now(time, q, p, rec, held, s, s[8:12])


def dragged(*stages):
    """The line with a damper at the tip, whose force needs the speeds; its own stages come last."""
    s = sh.load("line-y24-velocity")
    controllers = (*((stage, 1) for stage in stages), *s.controllers)
    loads = (*s.loads, TipDrag(damping=20.0))
    return s.replace(loads=loads, t_end=0.3, controllers=controllers)


@pytest.mark.parametrize("simulate", ENGINES.values(), ids=list(ENGINES))
def test_behind_exact_readings_it_is_the_same(simulate):
    exact = Measurement(differenced=0.0)
    alone, behind = (simulate(dragged(*stages)) for stages in ((Shown(),), (exact, Shown())))
    assert np.array_equal(behind.held, alone.held)
    shown = alone.held[-1, 4:6]
    # The hand pushes along x alone: the rest is drag.
    assert abs(shown[1]) > 0.1


def test_coordinates_in_its_place_are_refused():
    with pytest.raises(InvalidInput, match=r"ByCoordinates\.step reads beyond q"):
        validate(dragged(ByCoordinates()))
