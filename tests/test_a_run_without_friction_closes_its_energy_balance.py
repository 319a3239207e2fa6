"""The energy check passes where nothing rubs or works, and still finds what is missing."""

import math
from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.one_axis import OneAxis
from simpter_hybrid.engine import simulate
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario


def free(q, qd, weight):
    clutch = Clutch(torque=LinearTorque(rated=1.0))
    axis = OneAxis(inertia=1.0, weight=weight)
    return simulate(Scenario("free", axis, (clutch,), q=(q,), qd=(qd,), t_end=2.0))


@pytest.mark.parametrize(
    ("q", "qd", "weight"),
    [(1.0, 0.0, 9.81), (0.0, 3.0, 0.0), (0.0, 0.0, 0.0), (math.pi, 0.0, 9.81)],
    ids=["swing", "coasting rotor", "rest", "rest at the top"],
)
def test_it_closes(q, qd, weight):
    assert energy_balance(free(q, qd, weight)).relative < 1e-12


def test_a_swing_turns_over_what_it_exchanges():
    balance = energy_balance(free(1.0, 0.0, 9.81))
    assert balance.turnover == pytest.approx(9.81 * (1.0 - np.cos(1.0)), rel=1e-3)


def test_energy_that_is_missing_is_still_found():
    run = free(1.0, 0.0, 9.81)
    seen = sample(run)
    lossy = replace(seen, kinetic=seen.kinetic * np.exp(-1e-4 * seen.t))
    assert energy_balance(run, lossy).relative > 1e-5
