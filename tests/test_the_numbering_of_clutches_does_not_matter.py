"""PTER with its clutches numbered otherwise moves the same."""

import itertools
import random
from dataclasses import dataclass

import numpy as np
import pytest
from random_runs import random_run

from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.engine import simulate

ORDERS = random.Random(5).sample(list(itertools.permutations(range(4))), 4)


@dataclass(frozen=True)
class Renumbered(Pter):
    """PTER whose clutch i is clutch ``order`` digit i of PTER."""

    order: float = 123.0

    @staticmethod
    def clutch_map(q, p, out):
        rows = [1.0, 0.0, 0.0, 1.0, 1.0, -1.0, 1.0, 1.0]
        left = int(p[5])
        for k in range(4):
            i = left // 10 ** (3 - k) % 10
            out[2 * k] = rows[2 * i]
            out[2 * k + 1] = rows[2 * i + 1]

    def case_of(self, mode):
        return ""


def renumbered(run, order):
    """The same run with its clutches in another order."""
    d = run.device
    code = float(int("".join(map(str, order))))
    device = Renumbered(d.alpha, d.beta, d.gamma, d.l_a, d.l_d, code)
    rec = np.reshape(run.rec, (-1, 4))[:, order].ravel() if run.rec else ()
    return run.replace(
        device=device,
        clutches=tuple(run.clutches[i] for i in order),
        command=tuple(run.command[i] for i in order),
        excitation=tuple(run.excitation[i] for i in order),
        rec=tuple(rec),
    )


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(("kind", "seed"), [("constant", 0), ("constant", 3), ("30 Hz", 2)])
def test_another_order(kind, seed, order):
    run = random_run(kind, seed, 2.0)
    plain, other = simulate(run), simulate(renumbered(run, order))
    size = np.abs(plain.end[:4]).max()
    assert plain.end[:4] == pytest.approx(other.end[:4], abs=1e-9 * size)
    moved = [tuple(e.after[i] for i in order) for e in plain.events]
    assert moved == [e.after for e in other.events]
