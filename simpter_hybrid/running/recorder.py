"""Collects a run's segments, steps and events into a ``Trajectory``."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..kernel.records import events_at_once
from ..kernel.rules import zeno
from ..scenario import Scenario
from ..trajectory import Event, Trajectory
from .failures import at_once, too_many


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
        """The modes now."""
        return tuple(w.mode[: self.m])

    def segment(self, t: float, w: Any) -> None:
        """Begin a segment."""
        self.segment_t.append([t, t])
        sizes = self.scenario.sizes()
        self.rows["mode"].append(tuple(w.mode[: self.m]))
        self.rows["gate"].append(tuple(w.gate[: self.m]))
        self.rows["held"].append(tuple(w.held[: sizes["nh"]]))
        self.rows["dmode"].append(tuple(w.dmode[: sizes["nd"]]))

    def close(self, t: float) -> None:
        """End the present segment at ``t``."""
        if self.segment_t:
            self.segment_t[-1][1] = t

    def steps(self, interpolants: list) -> None:
        """Keep the dense output of a segment's steps."""
        for piece in interpolants:
            self.step_t.append(piece.t_old)
            self.step_h.append(piece.h)
            self.step_y.append(piece.y_old)
            self.step_f.append(piece.F)
            self.step_segment.append(len(self.segment_t) - 1)

    def event(self, t: float, kind: str, before: tuple[int, ...], w: Any, **more: Any) -> None:
        """Log a transition, unless nothing changed."""
        after = tuple(w.mode[: self.m])
        changed = tuple(i + 1 for i in range(self.m) if before[i] != after[i])
        if not changed and kind != "breakaway":
            return
        case = self.scenario.device.case_of
        self.events.append(
            Event(t, kind, changed, before, after, case(before), case(after), **more)
        )

    def count_event(self, t: float) -> None:
        """Count an event against the Zeno limit.

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
        raise SimulationFailure(f"at t = {t!r} s {why}; last: {self.last_events()}")

    def last_events(self) -> str:
        """The last three events, for messages."""
        return "; ".join(
            f"t = {e.t!r} s {e.kind} clutch {e.clutches}: {e.before} -> {e.after}"
            for e in self.events[-3:]
        )

    def table(self, name: str, width: int, kind: type) -> np.ndarray:
        """The rows kept under ``name``, one a segment."""
        return np.array(self.rows[name], dtype=kind).reshape(len(self.segment_t), width)

    def trajectory(self, y, status: str, message: str, statistics: dict, engine: str) -> Trajectory:
        """The finished record."""
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
