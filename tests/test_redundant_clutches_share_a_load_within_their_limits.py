"""The stated rule of sharing: least sum of squared uses of the breakaway torques, none above 1.

Torques within their limits that hold the load are the least ones if and only if some vector x
explains them (Karush, Kuhn, Tucker): tau_i / tau_break_i^2 = a_i x where a torque is inside its
limits, and a_i x beyond that where it is at one.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest
from devices_for_tests import Coulomb

import simpter_hybrid as sh
from simpter_hybrid import compiled, engine
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controller import Controller
from simpter_hybrid.kernel.margin import share
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.measuring.sampling import sample

PTER = np.array([[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]])


def shared(rows, down, up, load):
    m, r = rows.shape
    fr = np.concatenate([np.zeros(m), down, up, np.zeros(2 * m)])
    tau = np.zeros(m)
    status = share(
        m, [0] * m, r, rows.ravel(), load, fr, tau, np.zeros(m, int), np.zeros(r * r + 2 * r)
    )
    assert status == 0
    return tau


def assert_least(rows, down, up, load):
    """The torques hold the load, keep their limits, and are the least that do."""
    tau = shared(rows, down, up, load)
    most = max(down.max(), up.max())
    # Sums of a few torques; a load this close to what the set can hold amplifies rounding.
    assert np.abs(rows.T @ tau - load).max() < 1e-11 * most
    assert (tau < up + 1e-9 * most).all()
    assert (tau > -down - 1e-9 * most).all()
    pull = tau / (0.5 * (down + up)) ** 2
    free = (tau < up - 1e-9 * most) & (tau > -down + 1e-9 * most)
    if np.linalg.matrix_rank(rows[free]) < rows.shape[1]:
        return  # at the edge of what it can hold: nothing is left to choose
    x = np.linalg.lstsq(rows[free], pull[free], rcond=None)[0]
    beyond = (rows @ x - pull) * np.sign(tau)
    scale = np.abs(pull).max()
    assert np.abs(beyond[free]).max() < 1e-6 * scale
    assert (beyond[~free] > -1e-6 * scale).all()


@pytest.mark.parametrize("near", [0.3, 1e-2, 1e-4, 1e-8])
def test_loads_up_to_what_the_set_can_hold(near):
    rng = np.random.default_rng(1)
    for k in range(300):
        rows = PTER if k % 2 == 0 else rng.normal(size=(6, 3))
        down = rng.uniform(0.1, 10.0, len(rows))
        up = down if k % 3 == 0 else rng.uniform(0.1, 10.0, len(rows))
        # The most that the set holds along some direction, less a little.
        most = np.where(rows @ rng.normal(size=rows.shape[1]) > 0.0, up, -down)
        assert_least(rows, down, up, rows.T @ (most * (1.0 - near * rng.random(len(rows)))))


#: A load near the most that clutches with these breakaway torques hold [N m].
BREAKAWAY = np.array([1.9945443688065332, 6.471678452657178, 9.999321228909318, 7.513600822098602])
LOAD = np.array([19.117317091418162, 3.9062388849295324])


def test_one_that_was_at_its_limit_first_is_set_free_again():
    assert_least(PTER, BREAKAWAY, BREAKAWAY, LOAD)
    use = shared(PTER, BREAKAWAY, BREAKAWAY, LOAD) / BREAKAWAY
    assert use == pytest.approx([0.804392, 0.987682, 1.0, 1.0], abs=1e-6)


@dataclass(frozen=True)
class Shown(Controller):
    """Holds the torques that a controller is shown."""

    feedback: ClassVar[bool] = True
    holds: ClassVar[tuple[str, ...]] = ("shown_1", "shown_2", "shown_3", "shown_4")

    @staticmethod
    def step(tau, m, held, at_shown_1):
        for i in range(m):
            held[at_shown_1 + i] = tau[i]


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
def test_controllers_are_shown_torques_within_the_limits_while_the_margin_is_positive(simulate):
    clutches = tuple(
        Clutch(Coulomb(b, b), time_constant=0.0, delay=0.0, threshold=-1.0) for b in BREAKAWAY
    )
    loads = tuple(RampOnCoordinate(-g, 0.0, 0.0, coordinate=float(j)) for j, g in enumerate(LOAD))
    run = simulate(sh.load("line-y24").replace(
        clutches=clutches, controllers=((Shown(), 1),), period=0.01, stops=(), loads=loads,
        t_end=0.05, command=(1.0,) * 4, excitation=(1.0,) * 4,
    ))  # fmt: skip
    found = sample(run, [0.045])
    assert (found.mode[0] == 0).all()
    assert found.margin[0] > 0.2
    assert (np.abs(run.held[-1, 4:]) < BREAKAWAY * (1.0 + 1e-9)).all()
    assert run.held[-1, 4:] == pytest.approx(found.tau[0], rel=1e-9)
