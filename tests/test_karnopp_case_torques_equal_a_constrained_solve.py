"""Appendix A as corrected, and the general rule, against constrained equations of motion."""

import itertools

import numpy as np
import pytest
from karnopp_states import C, random_mass, work

from simpter_hybrid.karnopp.appendix import pair, single
from simpter_hybrid.karnopp.general import torques

MAP = np.reshape(C, (4, 2))


def constrained(M, f, stuck, tau):
    """Accelerations and torques of the stuck clutches from one linear system."""
    S = MAP[list(stuck)]
    k = len(stuck)
    system = np.block([[np.reshape(M, (2, 2)), -S.T], [S, np.zeros((k, k))]])
    others = MAP.T @ [0.0 if i in stuck else tau[i] for i in range(4)]
    return np.linalg.solve(system, np.concatenate([np.array(f) + others, np.zeros(k)]))[2:]


@pytest.mark.parametrize("clutch", range(4))
def test_one_stuck_clutch(clutch):
    rng = np.random.default_rng(clutch)
    for _ in range(200):
        M, f, tau = random_mass(rng), rng.normal(size=2), rng.normal(size=4)
        wanted = constrained(M, f, (clutch,), tau)[0]
        # Two formulas of a dozen operations each; condition numbers stay below 1e4.
        assert single(clutch, M, f, tau) == pytest.approx(wanted, rel=1e-10, abs=1e-10)


@pytest.mark.parametrize("stuck", list(itertools.combinations(range(4), 2)))
def test_two_stuck_clutches(stuck):
    rng = np.random.default_rng(sum(stuck))
    for _ in range(200):
        M, f, tau = random_mass(rng), rng.normal(size=2), [0.0] * 4
        pair(*stuck, f, tau)
        wanted = constrained(M, f, stuck, tau)
        assert [tau[i] for i in stuck] == pytest.approx(wanted.tolist(), rel=1e-10, abs=1e-10)


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_the_general_rule_stops_the_slip_with_the_least_use_of_breakaway_torques(count):
    rng = np.random.default_rng(count)
    for stuck in itertools.combinations(range(4), count):
        M, f = random_mass(rng), rng.normal(size=2)
        now = [0.0 if i in stuck else v for i, v in enumerate(rng.normal(size=4))]
        breakaway = rng.uniform(1e8, 1e9, 4)  # ample
        w = work(M, f, breakaway, stuck, now=now)
        assert torques(2, 4, w) == 0
        S = MAP[list(stuck)]
        inverse = np.linalg.inv(np.reshape(M, (2, 2)))
        asked = -S @ inverse @ (f + MAP.T @ now)
        D = np.diag(breakaway[list(stuck)])
        wanted = D @ np.linalg.pinv(S @ inverse @ S.T @ D) @ asked
        found = [w.now[i] for i in stuck]
        assert found == pytest.approx(wanted.tolist(), rel=1e-8, abs=1e-8)
