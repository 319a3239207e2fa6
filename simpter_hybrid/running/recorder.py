"""Collects a run's segments, steps and events into a ``Trajectory``."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..kernel.records import events_at_once
from ..kernel.rules import zeno
from ..scenario import Scenario
from ..trajectory import Event, Trajectory
from .failures import at_once, last_events, too_many


class SimulationFailure(Exception):
    """A run that cannot go on; the partial trajectory is kept."""


class Recorder:
    """What a run leaves behind, in lists until it ends."""

    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario
        self.m = scenario.device.m
        self.step_t: list[float] = []
        self.step_h: list[float] = []
        self.step_y: list[np.ndarray] = []
        self.step_f: list[np.ndarray] = []
        self.step_segment: list[int] = []
        self.segment_t: list[list[float]] = []
        self.rows: dict[str, list[tuple]] = {"mode": [], "gate": [], "held": [], "dmode": []}
        self.events: list[Event] = []
        self.recent = [0.0] * events_at_once(self.m)
        self.counted = 0

    def snapshot(self, w: Any) -> tuple[int, ...]:
        """The modes now.

        Parameters
        ----------
        w : Work

        Returns
        -------
        tuple of int (m,)
        """
        return tuple(w.mode[: self.m])

    def segment(self, t: float, w: Any) -> None:
        """Begin a segment.

        Parameters
        ----------
        t : float
            [s].
        w : Work
            Its modes, gates, held inputs and discrete modes are those of the segment.
        """
        self.segment_t.append([t, t])
        sizes = self.scenario.sizes()
        self.rows["mode"].append(tuple(w.mode[: self.m]))
        self.rows["gate"].append(tuple(w.gate[: self.m]))
        self.rows["held"].append(tuple(w.held[: sizes["nh"]]))
        self.rows["dmode"].append(tuple(w.dmode[: sizes["nd"]]))

    def close(self, t: float) -> None:
        """End the present segment at ``t``.

        Parameters
        ----------
        t : float
            [s]; nothing happens where no segment has begun.
        """
        if self.segment_t:
            self.segment_t[-1][1] = t

    def steps(self, interpolants: list) -> None:
        """Keep the dense output of a segment's steps.

        Parameters
        ----------
        interpolants : list
            Of the last segment begun; each has ``t_old`` and ``h`` [s], ``y_old`` (ny,) and ``F``
            (nf, ny).
        """
        for piece in interpolants:
            self.step_t.append(piece.t_old)
            self.step_h.append(piece.h)
            self.step_y.append(piece.y_old)
            self.step_f.append(piece.F)
            self.step_segment.append(len(self.segment_t) - 1)

    def event(self, t: float, kind: str, before: tuple[int, ...], w: Any, **more: Any) -> None:
        """Log a transition, unless no clutch's mode changed (breakaways are always logged).

        Breakaways of one instant are one event, from the modes before the first of them.

        Parameters
        ----------
        t : float
            [s].
        kind : str
            As in `Event`.
        before : tuple of int (m,)
            Modes before it.
        w : Work
            With the modes after it.
        **more
            Further fields of `Event`.
        """
        after = tuple(w.mode[: self.m])
        if kind == "breakaway" and self.events:
            last = self.events[-1]
            if (last.t, last.kind) == (t, kind):
                before, more = last.before, {"margin": last.margin}
                self.events.pop()
        changed = tuple(i + 1 for i in range(self.m) if before[i] != after[i])
        if not changed and kind != "breakaway":
            return
        case = self.scenario.device.case_of
        self.events.append(
            Event(t, kind, changed, before, after, case(before), case(after), **more)
        )

    def count_event(self, t: float) -> None:
        """Count an event against the Zeno limit.

        Parameters
        ----------
        t : float
            [s].

        Raises
        ------
        SimulationFailure
            When too many events fall at one instant, or the run has had too many in all.
        """
        self.counted += 1
        if self.counted > self.scenario.event_limit:
            why = too_many(self.scenario.event_limit)
        elif zeno(self.m, t, self.counted, self.recent):
            why = at_once(events_at_once(self.m))
        else:
            return
        raise SimulationFailure(f"at t = {t!r} s {why}; {last_events(self.events)}")

    def table(self, name: str, width: int, kind: type) -> np.ndarray:
        """The rows kept under ``name``, one a segment.

        Parameters
        ----------
        name : str
            ``mode``, ``gate``, ``held`` or ``dmode``.
        width : int
            Numbers a row.
        kind : type
            ``int`` or ``float``.

        Returns
        -------
        ndarray (segments, width)
        """
        return np.array(self.rows[name], dtype=kind).reshape(len(self.segment_t), width)

    def trajectory(self, y, status: str, message: str, statistics: dict, engine: str) -> Trajectory:
        """The finished record.

        Parameters
        ----------
        y : sequence of float (ny,)
            Final state.
        status, message, engine : str
            As in `Trajectory`.
        statistics : dict
            Counts, to which that of events is added.
        """
        sizes = self.scenario.sizes()
        empty, no_rows = np.zeros((0, sizes["ny"])), np.zeros((0, sizes["nf"], sizes["ny"]))
        return Trajectory(
            step_t=np.array(self.step_t),
            step_h=np.array(self.step_h),
            step_y=np.array(self.step_y) if self.step_y else empty,
            step_f=np.array(self.step_f) if self.step_f else no_rows,
            step_segment=np.array(self.step_segment, dtype=int),
            segment_t=np.array(self.segment_t).reshape(-1, 2),
            mode=self.table("mode", self.m, int),
            gate=self.table("gate", self.m, int),
            held=self.table("held", sizes["nh"], float),
            dmode=self.table("dmode", sizes["nd"], int),
            end=np.array(y, dtype=float),
            events=tuple(self.events),
            status=status,
            message=message,
            statistics=statistics | {"events": len(self.events)},
            engine=engine,
            scenario=self.scenario,
        )
