"""A three-link arm with five clutches, two of them on Cartesian speeds of its tip."""

import random

import numpy as np
import pytest
from devices_for_tests import Arm, Waves, always_on
from energy_ledger import balance
from slip_while_stuck import largest_stuck_slip

from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

#: The stuck clutch's speed is integrated like the others; rounding over some hundred steps.
SLIP = 1e-14


def run_of(seed, gap, size, t_end=2.0, **options):
    """A random run; ``size`` scales the friction torques [N m]."""
    rng = random.Random(seed)
    lines = tuple(
        (float(j), rng.uniform(0.5, 3), rng.uniform(1, 9), rng.uniform(0, 6)) for j in (0, 1, 2) * 2
    )
    torques = [size * rng.uniform(0.05, 0.8) for _ in range(5)]
    q = tuple(rng.uniform(-1, 1) for _ in range(3))
    qd = (0.0,) * 3 if rng.random() < 0.5 else tuple(rng.uniform(-1, 1) for _ in range(3))
    return Scenario(
        f"arm {seed}", Arm(), tuple(always_on(s, gap * s) for s in torques), q, qd, t_end,
        loads=(Waves(lines),), command=(1.0,) * 5, excitation=(1.0,) * 5, **options,
    )  # fmt: skip


def clutch_map(q):
    out = [0.0] * 15
    Arm.clutch_map(list(q), list(Arm().parameters().values()), out)
    return np.reshape(out, (5, 3))


@pytest.mark.parametrize("gap", [1.0, 1.4])
@pytest.mark.parametrize(("seed", "size"), [(21, 1.0), (27, 1.0), (1, 2.0), (5, 3.0)])
def test_stuck_slip_and_energy(seed, size, gap):
    trajectory = simulate(run_of(seed, gap, size))
    assert trajectory.status == "finished", trajectory.message
    assert (trajectory.mode == 0).any()
    slip, seen = largest_stuck_slip(trajectory, clutch_map)
    assert seen > 20
    assert slip < SLIP
    missing, moved = balance(trajectory)
    assert abs(missing) <= 1e-8 * moved  # a run that stays locked moves nothing: 0 <= 0


@pytest.mark.parametrize("seed", [21, 27])
def test_denser_checks_find_the_same_events(seed):
    found = simulate(run_of(seed, 1.0, 1.5, 1.0))
    dense = simulate(run_of(seed, 1.0, 1.5, 1.0, max_step=0.002))
    assert [e.after for e in found.events] == [e.after for e in dense.events]
    assert found.end == pytest.approx(dense.end, abs=1e-8)
