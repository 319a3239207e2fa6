"""The model re-evaluated at an instant of a run, by the same functions that produced the run."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ..kernel.margin import facet_margin
from ..kernel.motion import constrain, enter_mode, evaluate, find_facets, hold
from ..kernel.records import FREE, STICK
from ..kernel.reduction import partition
from ..trajectory import Trajectory


@np.errstate(over="ignore", invalid="ignore")  # of a run that diverged
def states(trajectory: Trajectory, times: np.ndarray, segments: np.ndarray) -> np.ndarray:
    """States at ``times`` [s], each read from the segment given; (N, ny).

    The same numbers as ``Trajectory.state``, all at once.
    """
    if len(trajectory.step_t) == 0:
        return np.tile(trajectory.end, (len(times), 1))
    first = np.searchsorted(trajectory.step_segment, segments, side="left")
    last = np.searchsorted(trajectory.step_segment, segments, side="right") - 1
    instant = last < first
    j = np.clip(np.searchsorted(trajectory.step_t, times, side="right") - 1, first, last)
    j = np.where(instant, np.minimum(first, len(trajectory.step_t) - 1), j)
    x = ((times - trajectory.step_t[j]) / trajectory.step_h[j])[:, None]
    rows = trajectory.step_f[j]
    y = np.zeros((len(times), trajectory.end.size))
    for i in range(rows.shape[1] - 1, -1, -1):
        y = (y + rows[:, i]) * (x if i % 2 == 0 else 1.0 - x)
    y += trajectory.step_y[j]
    y[instant] = trajectory.step_y[j[instant]]
    y[times == trajectory.t_end] = trajectory.end
    return y


class Evaluation:
    """Evaluates a run's model: ``enter`` a segment, then go ``at`` an instant of it.

    Afterwards the work record ``w`` holds, beside what the kernel leaves there (``qdd``, ``tau``,
    ``lam``, ``M``, ``C``, ``Q``), in ``w.fr`` the slip torque now and the limits of *every* engaged
    clutch, slipping ones included.
    """

    def __init__(self, trajectory: Trajectory) -> None:
        self.trajectory = trajectory
        self.scenario = trajectory.scenario
        self.md = self.scenario.python_model()
        _, self.w = self.scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)
        self.functions = self.scenario.device.functions()
        self._tip_force = self.scenario.tip_force()
        self._unique: dict[tuple[int, ...], list[bool]] = {}
        self._jumps = frozenset(self.scenario.jumps())
        self._before_jump = math.nan

    @property
    def mode(self) -> tuple[int, ...]:
        """Modes of the clutches in the segment entered."""
        return tuple(self.w.mode[: self.md.m])

    def enter(self, segment: int, start: list[float] | None = None) -> None:
        """Take over modes, gates and held inputs of a segment; `start` is its state if known."""
        run, w = self.trajectory, self.w
        for name, rows in (
            ("mode", run.mode), ("gate", run.gate), ("held", run.held), ("dmode", run.dmode)
        ):  # fmt: skip
            values = rows[segment].tolist()
            getattr(w, name)[: len(values)] = values
        begin, end = run.segment_t[segment].tolist()
        self._before_jump = end if end in self._jumps and end > begin else math.nan
        if start is None:
            begins = run.segment_t[segment, :1]
            start = states(run, begins, np.array([segment]))[0].tolist()
        self.prepare(start)

    def prepare(self, y: list[float]) -> int:
        """Prepare for the modes in ``w`` at the configuration of ``y``; returns a kernel status."""
        return enter_mode(self.md, y, self.w)

    def at(self, t: float, y: list[float]) -> list[float]:
        """Evaluate at time ``t`` [s] and state ``y`` (ny,).

        Returns
        -------
        list of float
            ``y`` with the speeds that the stuck set leaves.
        """
        md, w = self.md, self.w
        t, y = self.instant(t), list(y)
        constrain(md, y, w)
        self.limits(t, y)
        evaluate(md, t, y, w)
        if w.meta[0] > 0:
            if not md.constant:
                find_facets(md, w)
            hold(md, w)
        return y

    def instant(self, t: float) -> float:
        """Time at which loads are asked [s]: what jumps at the segment's end does so after it."""
        return math.nextafter(t, 0.0) if t == self._before_jump else t

    def limits(self, t: float, y: list[float]) -> None:
        """Write what every engaged clutch could hold if it were at rest now into ``w.fr``."""
        md, w = self.md, self.w
        at_rest = [FREE if mode == FREE else STICK for mode in w.mode]
        w.fr[:] = [0.0] * len(w.fr)
        md.terms(t, y, md.p, md.rec, w.held, at_rest, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)

    def tip_force(self, t: float, y: list[float]) -> list[float]:
        """Sum of the forces on the tip (2,) [N]: what a force sensor in its handle reads."""
        out = [0.0] * 4
        self._tip_force(self.instant(t), y, self.md.p, self.md.rec, self.w.held, self.w.s, out)
        return out[:2]

    def margins(self) -> list[float]:
        """Margins of the stuck set's facets, two a facet [N m]; empty when nothing is stuck."""
        md, w = self.md, self.w
        rank = w.meta[0]
        return [
            facet_margin(md.m, rank, k, sign, w.fy, w.fp, w.lam, w.fr)
            for k in range(w.meta[1] if rank > 0 else 0)
            for sign in (1.0, -1.0)
        ]

    def unique(self) -> list[bool]:
        """Which clutch torques the equations of motion determine; (m,).

        The torque of a stuck clutch is not unique when the others hold the same motions without it.
        """
        if not self.md.constant:
            return unique_torques(self.md, self.w)
        found = self._unique.get(self.mode)
        if found is None:
            found = self._unique[self.mode] = unique_torques(self.md, self.w)
        return found

    def at_rest(self) -> list[bool]:
        """Whether each clutch's slip velocity is zero: stuck, or brought to rest by those; (m,)."""
        md, w = self.md, self.w
        rank = w.meta[0]
        rows, cols, scratch = [0] * (md.m + 1), [0] * md.n, [0.0] * len(w.s)
        stuck = [mode == STICK for mode in self.mode]
        found = list(stuck)
        for i in range(md.m):
            if rank > 0 and not stuck[i]:
                joined = [STICK if s or k == i else FREE for k, s in enumerate(stuck)]
                found[i] = partition(w.C, md.n, md.m, joined, rows, cols, scratch) == rank
        return found

    def slip(self, y: Sequence[float]) -> list[float]:
        """Slip velocities [rad/s], exactly 0.0 for stuck clutches; (m,)."""
        n, C = self.md.n, self.w.C
        return [
            0.0 if mode == STICK else sum(C[i * n + j] * y[n + j] for j in range(n))
            for i, mode in enumerate(self.mode)
        ]


def unique_torques(md, w) -> list[bool]:
    """See ``Evaluation.unique``; ranks by the kernel's own elimination."""
    rank = w.meta[0]
    stuck = [i for i in range(md.m) if w.mode[i] == STICK]
    found = [True] * md.m
    if len(stuck) > rank:
        rows, cols = [0] * (md.m + 1), [0] * md.n
        scratch = [0.0] * len(w.s)
        for i in stuck:
            others = [FREE if k == i else w.mode[k] for k in range(md.m)]
            found[i] = partition(w.C, md.n, md.m, others, rows, cols, scratch) < rank
    return found
