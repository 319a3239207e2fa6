"""Random instants with clutches at zero slip: the kernel's mode resolution and an enumeration.

Everything is batched: arrays have a leading axis of problems.  The enumeration shares no code with
the package; it tries every active set of the bounded problem.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, fields

import numpy as np

from simpter_hybrid.kernel.records import work_arrays
from simpter_hybrid.kernel.resolution import resolve

#: Slip accelerations below this share of the terms they are the sum of count as zero.
ROUNDING = 1e-9
FLAVOURS = ("generic", "nearly dependent", "at the limit", "whole numbers")


@dataclass
class Instants:
    """Problems of one size: n coordinates, m clutches (fields as in ``kernel.resolution``)."""

    M: np.ndarray
    f: np.ndarray
    C: np.ndarray
    c: np.ndarray
    fr: np.ndarray
    mode: np.ndarray
    zero: np.ndarray
    hold: np.ndarray

    def bounds(self, hold: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Torque limits of all clutches; a slipping one's both limits are its slip torque."""
        m = self.C.shape[1]
        brk_f, brk_b, slip_f, slip_b = (self.fr[:, (k + 1) * m : (k + 2) * m] for k in range(4))
        lo = np.where(hold, -brk_f, -slip_f)
        hi = np.where(hold, brk_b, slip_b)
        moving = np.where(abs(self.mode) == 1, -self.mode * self.fr[:, :m], 0.0)
        resting = self.zero == 1
        return np.where(resting, lo, moving), np.where(resting, hi, moving)

    def relaxed(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """A, d of ``sigma = A tau + d`` and the size of the terms of d."""
        inverse = np.linalg.inv(self.M)
        CM = self.C @ inverse
        d = np.einsum("bij,bj->bi", CM, self.f) + self.c
        size = np.einsum("bij,bj->bi", abs(CM), abs(self.f)) + abs(self.c)
        return CM @ self.C.transpose(0, 2, 1), d, size


def random_instants(rng, count: int, n: int, m: int, flavour: str) -> Instants:
    """Random problems: redundant rows, asymmetric limits, torques from 1e-6 to 1e6."""
    R = rng.normal(size=(count, n, n))
    M = (R @ R.transpose(0, 2, 1) + 0.05 * np.eye(n)) * 10.0 ** rng.uniform(-3, 3, (count, 1, 1))
    C = rng.integers(-1, 2, size=(count, m, n)).astype(float)
    if flavour in ("generic", "nearly dependent"):
        C = np.where(rng.random((count, 1, 1)) < 0.5, C, rng.normal(size=C.shape))
    C[~C.any(axis=2), 0] = 1.0
    for i in range(1, m):
        weights = rng.integers(-1, 2, size=(count, i)).astype(float)
        mixed = np.einsum("bi,bij->bj", weights, C[:, :i])
        pick = (rng.random(count) < 0.3) & (abs(mixed).max(axis=1) > 1e-6)
        if flavour == "nearly dependent":
            mixed += rng.normal(size=mixed.shape) * 10.0 ** -rng.uniform(3, 13, (count, 1))
        C[pick, i] = mixed[pick]
    scale = 10.0 ** rng.uniform(-6, 6, size=(count, 1))
    slip = rng.uniform(0, 1, (count, 2 * m)) * (rng.random((count, 2 * m)) < 0.95)
    gap = 1.0 + np.where(rng.random((count, 1)) < 0.3, 0.0, rng.uniform(0, 0.8, (count, 2 * m)))
    even = rng.random(count) < 0.6
    slip[even, m:], gap[even, m:] = slip[even, :m], gap[even, :m]
    f = rng.normal(size=(count, n)) * 10.0 ** rng.uniform(-1.5, 1, size=(count, 1))
    if flavour == "whole numbers":
        M = np.broadcast_to(np.eye(n), M.shape) * 2.0 ** rng.integers(-3, 3, (count, 1, 1))
        slip, gap = rng.integers(0, 4, slip.shape).astype(float), np.full_like(gap, 1.0)
        gap += rng.integers(0, 2, (count, 1))
        f, scale = rng.integers(-6, 7, f.shape).astype(float), np.ones_like(scale)
    drift = rng.normal(size=(count, m)) * scale * 0.3 / abs(M).max(axis=(1, 2))[:, None]
    c = np.where((rng.random((count, 1)) < 0.5) | (flavour == "whole numbers"), 0.0, drift)
    fr = np.zeros((count, 5 * m + 1))
    fr[:, :m] = scale * rng.uniform(0, 1, (count, m))
    fr[:, m : 3 * m], fr[:, 3 * m : 5 * m] = scale * slip * gap, scale * slip
    zero = (rng.random((count, m)) < 0.8).astype(np.int64)
    mode = np.where(zero == 1, 0, rng.choice((-1, 1, 2), size=(count, m)))
    hold = zero * (rng.random((count, m)) < 0.7)
    found = Instants(M, f * scale, C, c, fr, mode, zero, hold)
    if flavour == "at the limit":
        # The load that one vertex of the torque limits just balances, or misses by a little.
        lo, hi = found.bounds(hold)
        vertex = np.where(rng.random((count, m)) < 0.5, lo, hi)
        miss = rng.choice((-1.0, 0.0, 1.0), (count, n)) * 10.0 ** -rng.uniform(3, 17, (count, n))
        found.f = -np.einsum("bij,bi->bj", C, vertex) * (1.0 + miss)
        found.c = np.zeros_like(c)
    return found


def resolved(instants: Instants) -> tuple[np.ndarray, np.ndarray]:
    """Modes and torques by the package's kernel."""
    count, m, n = instants.C.shape
    w = work_arrays(n, m, 2 * n + 2 * m + 2, 0, m, 0, 0, lambda k: [0.0] * k, lambda k: [0] * k)
    modes, torques = np.zeros((count, m), dtype=int), np.zeros((count, m))
    none = [0.0] * (m + 1)
    for b in range(count):
        mode, hold = instants.mode[b].tolist(), instants.hold[b].tolist()
        arrays = (instants.M[b], instants.f[b], instants.C[b], instants.c[b], instants.fr[b])
        status = resolve(
            n, m, *(a.ravel().tolist() for a in arrays), mode, instants.zero[b].tolist(), hold,
            none, 0.0, w,
        )  # fmt: skip
        assert status == 0, (status, b)
        modes[b] = mode
        torques[b, instants.zero[b] == 1] = w.x[: int(instants.zero[b].sum())]
    return modes, torques


def inconsistent(instants: Instants, modes: np.ndarray, torques: np.ndarray) -> np.ndarray:
    """Which results violate a law: a torque beyond its limit, slip along its torque, held slip."""
    A, d, size = instants.relaxed()
    zero = instants.zero == 1
    lo, hi = instants.bounds(instants.hold == 1)
    least, most = instants.bounds(np.zeros_like(zero))
    tau = np.where(zero, torques, lo)
    sigma = np.einsum("bij,bj->bi", A, tau) + d
    size = size + np.einsum("bij,bj->bi", abs(A), abs(tau))
    reach = 1e-12 * np.maximum(abs(lo), abs(hi))
    stuck, forward, backward = (zero & (modes == s) for s in (0, 1, -1))
    wrong = stuck & ((tau < lo - reach) | (tau > hi + reach) | (abs(sigma) > ROUNDING * size))
    wrong |= forward & ((tau != least) | (sigma < 0)) | backward & ((tau != most) | (sigma > 0))
    return wrong.any(axis=1)


def undecided(instants: Instants, modes: np.ndarray, rng, nudges: int = 60) -> np.ndarray:
    """Which enumerated ``modes`` change when the loads change by less than 1e-6 of themselves."""
    changed = np.zeros(len(modes), dtype=bool)
    for _ in range(nudges):
        left = np.flatnonzero(~changed)
        if len(left) == 0:
            break
        nudge = rng.uniform(-3e-7, 3e-7, (len(left), modes.shape[1]))
        changed[left] = (enumerated(some(instants, left), nudge) != modes[left]).any(axis=1)
    return changed


def some(instants: Instants, which: np.ndarray) -> Instants:
    """The chosen problems."""
    return Instants(*(getattr(instants, name.name)[which] for name in fields(Instants)))


def enumerated(instants: Instants, nudge: np.ndarray | None = None) -> np.ndarray:
    """Modes by the rule, every bounded problem solved by trying all its active sets."""
    A, d, size = instants.relaxed()
    if nudge is not None:
        d = d + nudge * size
    hold = instants.hold == 1
    zero = instants.zero == 1
    while True:
        sigma, size_now = least_motion(A, d, size, *instants.bounds(hold), instants.C.shape[2])
        found = np.where(abs(sigma) <= ROUNDING * size_now, 0, np.sign(sigma)).astype(int)
        lost = hold & (found != 0)
        if not lost.any():
            return np.where(zero, found, instants.mode)
        hold &= ~lost


def least_motion(A, d, size, lo, hi, rank):
    """Slip accelerations at the least ``1/2 x'Ax + d'x`` in the limits, and their terms' size."""
    count, m = d.shape
    best, sigma_best = np.full(count, np.inf), np.zeros((count, m))
    size_best = np.ones((count, m))
    unit = np.sqrt(np.maximum(np.einsum("bii->bi", A), 1e-300))
    reach = np.max(hi - lo, axis=1) + 1e-300
    for inside in itertools.chain(
        *(itertools.combinations(range(m), k) for k in range(min(rank, m) + 1))
    ):
        P, F = list(inside), [i for i in range(m) if i not in inside]
        block = A[:, P][:, :, P]
        fit = np.ones(count, dtype=bool)
        if P:
            scaled = block / (unit[:, P, None] * unit[:, None, P])
            fit = np.linalg.eigvalsh(scaled)[:, 0] > 1e-9
            block = np.where(fit[:, None, None], block, np.eye(len(P)))
        for signs in itertools.product((1, -1), repeat=len(F)):
            x = np.zeros((count, m))
            x[:, F] = np.where(np.array(signs) > 0, lo[:, F], hi[:, F])
            if P:
                right = -(d + np.einsum("bij,bj->bi", A, x))[:, P]
                x[:, P] = np.linalg.solve(block, right[..., None])[..., 0]
            sigma = np.einsum("bij,bj->bi", A, x) + d
            terms = size + np.einsum("bij,bj->bi", abs(A), abs(x))
            wrong = np.zeros(count)
            if P:
                over = np.maximum(lo[:, P] - x[:, P], x[:, P] - hi[:, P]).max(axis=1)
                wrong = np.maximum(wrong, over / reach)
            for i, s in zip(F, signs, strict=True):
                against = -s * sigma[:, i] / (terms[:, i] + 1e-300)
                against = np.where(hi[:, i] > lo[:, i], against, 0.0)
                wrong = np.maximum(wrong, against)
            better = fit & (wrong < best - 1e-13)
            best = np.where(better, wrong, best)
            sigma_best = np.where(better[:, None], sigma, sigma_best)
            size_best = np.where(better[:, None], terms, size_best)
    return sigma_best, size_best
