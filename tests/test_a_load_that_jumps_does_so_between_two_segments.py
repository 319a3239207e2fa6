"""A damped spring is pulled round corners: its force jumps there, and neither side errs."""

from itertools import pairwise

import numpy as np
import pytest
from devices_for_tests import Block, always_on
from scipy.linalg import expm

from simpter_hybrid import compiled, engine
from simpter_hybrid.loads.pulled_spring import PulledSpring
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.measuring.variation import total_variation
from simpter_hybrid.on_grid import simulate_on_grid
from simpter_hybrid.scenario import Scenario

STIFFNESS, DAMPING = 10.0, 5.0
POINTS = ((0.0, 0.0), (0.31, 0.31), (0.62, 0.0), (0.9, 0.5))
SPEEDS = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in pairwise(POINTS)] + [0.0]
PULLED = Scenario(
    "pulled", Block(), (always_on(1e-12, 1e-12),), (0.0,), (0.0,), 1.2,
    loads=(PulledSpring(POINTS, STIFFNESS, DAMPING, 0.0),), command=(1.0,), excitation=(1.0,),
)  # fmt: skip


def exact(t):
    """Position and speed by the matrix exponential from corner to corner."""
    flow = np.zeros((4, 4))
    flow[0, 1] = flow[2, 3] = 1.0
    flow[1] = -STIFFNESS, -DAMPING, STIFFNESS, DAMPING
    z = np.zeros(4)
    for (begin, position), speed, (end, _) in zip(
        POINTS, SPEEDS, (*POINTS[1:], (9.0, 0.0)), strict=True
    ):
        z[2:] = position, speed
        z = expm(flow * (min(end, t) - begin)) @ z
        if t <= end:
            break
    return z[:2]


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
def test_both_sides_of_a_corner_are_their_own(simulate):
    run = simulate(PULLED)
    times = np.linspace(0.01, 1.2, 60)
    wrong = max(np.abs(run.state(t)[:2] - exact(t)).max() for t in times)
    assert wrong < 1e-11  # the tolerance is 1e-9 a step; corners add nothing
    whole = simulate(PULLED.replace(loads=(PulledSpring((POINTS[0], (1.2, 1.2)), 10.0, 5.0),)))
    # A corner costs a step or two of the run without corners.
    assert run.statistics["steps"] <= whole.statistics["steps"] + 2 * (len(POINTS) - 1)
    corners = [t for t, _ in POINTS[1:]]
    jumps = np.diff(sample(run, np.repeat(corners, 2), ["left", "right"] * 3).load[:, 0])[::2]
    expected = DAMPING * np.diff(SPEEDS)
    assert jumps == pytest.approx(expected, abs=1e-9)
    # What an acceleration jumps by is the force that does, of a mass of 1 kg.
    found = total_variation(run).jump
    assert np.sort(found)[-3:] == pytest.approx(np.sort(np.abs(expected)), abs=1e-9)


def test_rows_at_a_corner_are_of_the_state_there():
    rows = simulate_on_grid(PULLED, np.array([0.31, 0.62]))
    for k, t in enumerate((0.31, 0.62)):
        assert [rows.q[k, 0], rows.qd[k, 0]] == pytest.approx(exact(t).tolist(), abs=1e-11)
