"""Random instants of PTER at rest for tests of the Karnopp simulator's torques."""

from __future__ import annotations

import numpy as np

from simpter_hybrid.karnopp import records
from simpter_hybrid.kernel.records import work_arrays as shared_arrays

#: PTER's clutch map, row-major.
C = [1.0, 0.0, 0.0, 1.0, 1.0, -1.0, 1.0, 1.0]


def work(M, f, breakaway, stuck, last=(0.0, 0.0, 0.0, 0.0), now=(0.0, 0.0, 0.0, 0.0)):
    """A Karnopp work record of PTER with the given numbers; ``stuck`` lists clutches from 0."""

    def reals(k):
        return [0.0] * k

    def integers(k):
        return [0] * k

    w = records.work_arrays(
        shared_arrays(2, 4, 14, 0, 4, 0, 0, reals, integers), 2, 4, 14, 0, reals, integers
    )
    w.M[:], w.f[:], w.C[: len(C)] = list(M), list(f), C
    w.fr[4:8], w.fr[8:12] = list(breakaway), list(breakaway)
    w.last[:], w.now[:] = list(last), list(now)
    for i in stuck:
        w.stuck[i] = 1
    return w


def random_mass(rng) -> list[float]:
    """A positive definite symmetric 2x2 matrix, row-major."""
    root = rng.normal(size=(2, 2))
    return (root @ root.T + 0.2 * np.eye(2)).ravel().tolist()
