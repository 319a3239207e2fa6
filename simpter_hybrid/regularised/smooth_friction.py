"""The right-hand side of friction made smooth; see ``regularised``."""

from __future__ import annotations

import math

import numpy as np

from ..running.recorder import SimulationFailure
from ..scenario import Scenario

#: Speed of the breakaway torque over the width of the tanh, where the tanh has all but saturated.
BREAKAWAY = 10.0


class Smooth:
    """The regularised model of one scenario."""

    def __init__(self, scenario: Scenario, width: float) -> None:
        self.scenario, self.width = scenario, width
        self.md = scenario.python_model()
        self.y, self.w = scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)
        self.nfev = 0
        self.slip = [0.0] * self.md.m
        self.dy = [0.0] * self.md.ny
        for i in range(self.md.m):
            self.w.mode[i] = 2

    def torques(self, t: float, y: list[float]) -> None:
        """Clutch torques at (t, y) into ``w.tau``, the model's terms into ``w``.

        Parameters
        ----------
        t : float
            [s].
        y : list of float (ny,)
            State.
        """
        md, w = self.md, self.w
        n, m = md.n, md.m
        md.map(y, md.p, w.C)
        for i in range(m):
            self.slip[i] = sum(w.C[i * n + j] * y[n + j] for j in range(n))
        # Breakaway and slip torque at rest first, the slip torque at speed last.  Bristles are
        # smooth already and have a sign of their own: they are taken as they are, in mode 1.
        for stuck in (True, False):
            for i in range(m):
                moving = 1 if self.slip[i] >= 0.0 or md.smooth[i] == 1 else -1
                holds = stuck and md.smooth[i] == 0
                w.mode[i] = 2 if w.gate[i] != 2 else 0 if holds else moving
            if stuck:
                self.terms(t, y)
                rest = w.fr[: 5 * m]
        self.terms(t, y)
        for i in range(m):
            w.tau[i] = 0.0
            if w.gate[i] == 2 and md.smooth[i] == 1:
                w.tau[i] = -w.fr[i]
            elif w.gate[i] == 2:
                x = self.slip[i] / self.width
                back = self.slip[i] < 0.0
                gap = rest[(2 if back else 1) * m + i] - rest[(4 if back else 3) * m + i]
                s = x / BREAKAWAY / math.sqrt(2.0)
                bump = math.sqrt(2.0 * math.e) * gap * s * math.exp(-s * s)
                w.tau[i] = -(w.fr[i] * math.tanh(x) + bump)

    def terms(self, t: float, y: list[float]) -> None:
        """The model's terms for the modes in ``w``.

        Parameters
        ----------
        t, y
            As for `torques`.
        """
        md, w = self.md, self.w
        md.terms(t, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)

    def __call__(self, t: float, y: np.ndarray) -> np.ndarray:
        """Derivative of the state vector."""
        self.nfev += 1
        md, w, dy = self.md, self.w, self.dy
        n, m = md.n, md.m
        values = y.tolist()
        self.torques(t, values)
        load = [w.f[j] + sum(w.C[i * n + j] * w.tau[i] for i in range(m)) for j in range(n)]
        qdd = np.linalg.solve(np.reshape(w.M, (n, n)), load).tolist()
        qd = values[n : 2 * n]
        dy[:n], dy[n : 2 * n] = qd, qdd
        md.rates(t, values, md.p, md.rec, w.held, w.mode, w.gate, w.dmode, w.tau, w.C, w.s, dy)
        at = md.ny - m - 2
        dy[at] = sum(w.Q[j] * qd[j] for j in range(n))
        dy[at + 1] = sum(w.Q[n + j] * qd[j] for j in range(n))
        for i in range(m):
            dy[at + 2 + i] = -w.tau[i] * self.slip[i]
        if not math.isfinite(sum(dy)):
            raise SimulationFailure(f"the derivative is not finite at t = {float(t)!r} s")
        return np.array(dy)

    def jacobian(self, t: float, y: np.ndarray) -> np.ndarray:
        """Forward differences; nothing depends on the ledger of work.

        Parameters
        ----------
        t : float
            [s].
        y : ndarray (ny,)
            State.

        Returns
        -------
        ndarray (ny, ny)
            Change of every rate (rows) with every state.
        """
        ny = self.md.ny
        found = np.zeros((ny, ny))
        base = self(t, y)
        for j in range(ny - self.md.m - 2):
            step = 1e-8 * max(abs(y[j]), 1e-3 if j < self.md.n else 10.0 * self.width)
            moved = y.copy()
            moved[j] += step
            found[:, j] = (self(t, moved) - base) / step
        return found

    def modes(self, t: float, y: list[float]) -> tuple[int, ...]:
        """Modes for the record: stuck below the speed of the breakaway torque.

        Parameters
        ----------
        t, y
            As for `torques`.

        Returns
        -------
        tuple of int (m,)
            BACKWARD -1, STICK 0, FORWARD 1, FREE 2.
        """
        self.torques(t, y)
        found = []
        for i, slip in enumerate(self.slip):
            bristles = self.md.smooth[i] == 1
            stuck = abs(slip) <= BREAKAWAY * self.width and not bristles
            moving = 1 if slip > 0.0 or bristles else -1
            found.append(2 if self.w.gate[i] != 2 else 0 if stuck else moving)
        return tuple(found)

    def read(self, y: list[float], modes: tuple[int, ...]) -> list[float]:
        """What the controllers read: ``y`` with the creep of stuck clutches taken out, exactly.

        Parameters
        ----------
        y : list of float (ny,)
            State for which `modes` was asked last: its clutch map is used.
        modes : tuple of int (m,)
            As that gave them.
        """
        n = self.md.n
        rows = [list(self.w.C[i * n : (i + 1) * n]) for i, mode in enumerate(modes) if mode == 0]
        return y[:n] + without_slip(rows, y[n : 2 * n]) + y[2 * n :]


def without_slip(rows: list[list[float]], speeds: list[float]) -> list[float]:
    """``speeds`` (n,) with ``rows`` times speeds made zero; exactly so for rows of 0 and +-1.

    Parameters
    ----------
    rows : list of list of float, (k, n)
        Of the clutch map; they may depend on each other.
    speeds : list of float (n,)
        [rad/s or m/s].
    """
    n = len(speeds)
    pivots: list[int] = []
    kept: list[list[float]] = []
    for row in rows:
        for p, other in zip(pivots, kept, strict=True):
            factor = row[p]
            row = [a - factor * b for a, b in zip(row, other, strict=True)]
        p = max(range(n), key=lambda j: abs(row[j]))
        if abs(row[p]) > 1e-9:
            row = [a / row[p] for a in row]
            for k, other in enumerate(kept):
                factor = other[p]
                kept[k] = [a - factor * b for a, b in zip(other, row, strict=True)]
            pivots.append(p)
            kept.append(row)
    found = list(speeds)
    for p, row in zip(pivots, kept, strict=True):
        found[p] = -sum(row[j] * speeds[j] for j in range(n) if j not in pivots)
    return found
