"""Pieces of one run: each is replayed knowing those before it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from ..fitting.replay import Replay
from ..recordings.recorded_run import RecordedRun
from ..recordings.row_step import GAP, row_step


def replayed(
    chosen: Sequence[RecordedRun], every: Sequence[RecordedRun],
    made: Callable[[RecordedRun], Replay],
) -> list[Replay]:  # fmt: skip
    """Replays of the chosen runs; a piece has the one before it, if no rows are missing between.

    Parameters
    ----------
    chosen, every : sequence of RecordedRun
        Those wanted, and all of the recording.
    made : callable
        A run's replay.
    """
    known: dict[tuple[int, int], Replay] = {}

    def of(run: RecordedRun) -> Replay:
        if run.rows not in known:
            first = next((r for r in every if run.goes_on(r) and _meet(r, run)), None)
            before = None if first is None else of(first)
            known[run.rows] = replace(made(run), stamp=float(run.time[0]), before=before)
        return known[run.rows]

    return [of(run) for run in chosen]


def since_its_beginning(replay: Replay) -> float:
    """Time from the first sample of a whole run to the last one of this piece of it [s]."""
    first = replay
    while first.before is not None:
        first = first.before
    return replay.stamp - first.stamp + float(replay.time[-1])


def _meet(before: RecordedRun, run: RecordedRun) -> bool:
    return float(run.time[0] - before.time[-1]) <= GAP * row_step(run.time)
