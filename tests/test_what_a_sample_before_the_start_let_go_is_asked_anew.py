"""Whether a clutch holds when a run begins does not depend on whether controllers read torques.

A controller that does is shown those of the commands before its first sample, with which clutches
may slip. With the commands that it then writes they may hold: only these count.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest
from devices_for_tests import Block, Coulomb, Ramp

from simpter_hybrid import compiled, engine
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controller import Controller
from simpter_hybrid.on_grid import simulate_on_grid
from simpter_hybrid.scenario import Scenario

ENGINES = [engine, compiled]


@dataclass(frozen=True)
class Hold(Controller):
    """Full command from the start on."""

    @staticmethod
    def step(held):
        held[0] = 1.0


@dataclass(frozen=True)
class HoldAndFeel(Controller):
    """The same by one that may read torques."""

    feedback: ClassVar[bool] = True

    @staticmethod
    def step(held, tau):
        held[0] = 1.0


def block(controller, **more):
    """Pushed with 0.9 N where the clutch gives 0.1 N before its first sample and 1 N after it."""
    clutch = Clutch(Coulomb(0.8, 1.0), time_constant=0.0, delay=0.0, threshold=0.01)
    return Scenario(
        "x", Block(), (clutch,), (0.0,), (0.0,), 0.5, loads=(Ramp(0.0, ((0.0, 0.9),)),),
        controllers=((controller, 1),), period=0.1, command=(0.1,), excitation=(0.1,),
        **more,
    )  # fmt: skip


@pytest.mark.parametrize("simulate", [e.simulate for e in ENGINES], ids=["reference", "compiled"])
@pytest.mark.parametrize("controller", [Hold(), HoldAndFeel()], ids=["plain", "feedback"])
def test_a_clutch_commanded_at_the_first_sample_holds(simulate, controller):
    run = simulate(block(controller))
    assert run.events[0].after == (0,)
    assert run.end[0] == 0.0


@dataclass(frozen=True)
class HoldLater(Controller):
    """Full command from the third sample on."""

    @staticmethod
    def step(k, held):
        held[0] = 1.0 if k > 2 else 0.1


def test_so_does_one_commanded_at_a_restart():
    grid = np.array([0.2, 0.31, 0.5])
    # Samples are taken at multiples of the period: the fourth is the restart.
    at_rest = np.array([3 * 0.1]), np.array([[0.0]]), np.array([[0.0]])
    found = simulate_on_grid(block(HoldLater()), grid, at_rest)
    assert found.q[0, 0] > 0.01
    assert np.array_equal(found.q[1:, 0], [0.0, 0.0])
