"""The record of a Karnopp run: room for it, and what it becomes."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ..running.blame import held_names
from ..running.failures import at_sample
from ..scenario import Scenario
from ..trajectory import Event, Trajectory
from . import records
from .run import CHATTER, FINISHED, FULL, NOT_FINITE, NOT_HELD, SINGULAR, STOPPED

#: Status of a run that an exception of a part has ended.
PART_FAILED = 11

#: Why a run fails, by status.
FAILURES = {
    SINGULAR: "the mass matrix is singular",
    NOT_FINITE: "the state or its derivative is not finite",
    CHATTER: "the limit of steps is reached (max_steps): a clutch chatters on the edge of the band",
    FULL: "more steps or changes of mode than are kept; take a longer step or a wider band",
}


def empty_record(scenario: Scenario, steps: int, segments: int, grid: Any) -> records.Record:
    """A record with room for so many steps and segments, and for states at ``grid`` [s]."""
    z = scenario.sizes()
    m, ny = z["m"], z["ny"]

    def integers(k: int) -> np.ndarray:
        return np.zeros(k, dtype=np.int64)

    return records.Record(
        n=integers(8), event_t=np.zeros(segments), event_mode=integers(2 * m * segments),
        segment_t=np.zeros(segments), mode=integers(m * segments), gate=integers(m * segments),
        held=np.zeros(z["nh"] * segments), dmode=integers(z["nd"] * segments + 1),
        step_t=np.zeros(steps), step_h=np.zeros(steps), step_y=np.zeros(ny * steps),
        step_f=np.zeros(3 * ny * steps), step_segment=integers(steps),
        grid=np.array(grid, dtype=float), rows=np.zeros(ny * len(grid)), end=np.zeros(1),
        step_room=steps, segment_room=segments, ngrid=len(grid),
    )  # fmt: skip


class Ended(NamedTuple):
    """How a run has ended.

    Parameters
    ----------
    status : int
        As in ``karnopp.run``, or ``PART_FAILED``.
    t : float
        Instant at which it ended [s].
    which : int
        Stop condition or held input that ended it, from 0; -1 if none did.
    y : array (ny,)
        State there.
    said : str
        What a part's failure is called.
    """

    status: int
    t: float
    which: int
    y: Any
    said: str = ""


def outcome(scenario: Scenario, ended: Ended) -> tuple[str, str]:
    """Status and message of a run."""
    status, t, which, _, said = ended
    if status == PART_FAILED:
        return "failed", said
    if status == FINISHED:
        return "finished", "reached t_end"
    if status == STOPPED:
        stop: Any = scenario.stops[which]
        return "stopped" if stop.code == 2 else "failed", f"{stop.reason} at t = {t!r} s"
    if status == NOT_HELD:
        wrong = f"{held_names(scenario)[which]} is not a finite number"
        return "failed", at_sample(t, wrong)
    return "failed", f"at t = {t!r} s {FAILURES[status]}"


def events_of(scenario: Scenario, rec: records.Record) -> tuple[Event, ...]:
    """The changes of mode that Karnopp's model saw."""
    m, count = scenario.device.m, int(rec.n[records.EVENTS])
    case = scenario.device.case_of
    found = []
    rows = rec.event_mode[: 2 * m * count].reshape(count, 2, m).tolist()
    for t, (before, after) in zip(rec.event_t[:count].tolist(), rows, strict=True):
        changed = [i for i in range(m) if before[i] != after[i]]
        kind = "slip stop"
        if any(2 in (before[i], after[i]) for i in changed):
            kind = "switched" if t > 0.0 else "start"
        elif any(before[i] == 0 for i in changed):
            kind = "breakaway"
        b, a = tuple(before), tuple(after)
        found.append(Event(t, kind, tuple(i + 1 for i in changed), b, a, case(b), case(a)))
    return tuple(found)


def statistics(rec: records.Record) -> dict[str, int]:
    """Counts of what the run took."""
    n = rec.n.tolist()
    return {
        "segments": n[records.SEGMENTS],
        "steps": n[records.STEPS],
        "rhs_evaluations": n[records.EVALUATIONS],
        "rejected_steps": n[records.REJECTED],
        "steps_forced_at_least_size": n[records.FORCED],
        "events": n[records.EVENTS],
    }


def trajectory(scenario: Scenario, rec: records.Record, ended: Ended, engine: str) -> Trajectory:
    """The record as a Trajectory."""
    z = scenario.sizes()
    K, m, ny, nh, nd = int(rec.n[records.SEGMENTS]), z["m"], z["ny"], z["nh"], z["nd"]
    S = min(int(rec.n[records.STEPS]), len(rec.step_t))
    word, message = outcome(scenario, ended)
    starts = rec.segment_t[:K]
    return Trajectory(
        step_t=rec.step_t[:S].copy(),
        step_h=rec.step_h[:S].copy(),
        step_y=rec.step_y[: S * ny].reshape(S, ny).copy(),
        step_f=rec.step_f[: 3 * S * ny].reshape(S, 3, ny).copy(),
        step_segment=rec.step_segment[:S].copy(),
        segment_t=np.column_stack([starts, np.append(starts, ended.t)[1:]]),
        mode=rec.mode[: K * m].reshape(K, m).copy(),
        gate=rec.gate[: K * m].reshape(K, m).copy(),
        held=rec.held[: K * nh].reshape(K, nh).copy(),
        dmode=rec.dmode[: K * nd].reshape(K, nd).copy(),
        end=np.array(ended.y, dtype=float),
        events=events_of(scenario, rec),
        status=word,
        message=message,
        statistics=statistics(rec),
        engine=engine,
        scenario=scenario,
    )
