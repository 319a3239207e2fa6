"""Runs of which rows are missing, cut where they are: nothing predicts across what was not seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .checks import Finding
from .recorded_run import RecordedRun
from .recording import Recording
from .row_step import gaps
from .runs import name_of_whole

#: A run is cut where what is long enough still holds this part of its samples.
WORTH = 0.5


def runs_between_gaps(
    recording: Recording, groups: Sequence[str], shortest: float
) -> list[RecordedRun]:
    """Runs of the given groups that end at a gap of time, and go on behind it as runs of their own.

    Parameters
    ----------
    recording : Recording
    groups : sequence of str
        All, if none is given.
    shortest : float
        Pieces that last less are left out [s], unless they are most of the run: a run of many short
        pieces stays whole.
    """
    chosen = [r for r in recording.runs if not groups or r.group in groups]
    return [piece for run in chosen for piece in _pieces(run, shortest)]


def left_out(recording: Recording, shortest: float) -> tuple[Finding, ...]:
    """The pieces between gaps of which `runs_between_gaps` makes no run."""
    right = f"at least {shortest:g} s between gaps to predict from"
    what = "a piece between gaps is left out"
    return tuple(
        Finding(
            run.name, what, f"{_lasts(run, span):.3g} s", right,
            run.row(span.start), float(run.time[span.start]),
        )
        for run in recording.runs
        if (kept := _kept(run, shortest)) != [_whole(run)]
        for span in _spans(run)
        if span not in kept
    )  # fmt: skip


def _pieces(run: RecordedRun, shortest: float) -> list[RecordedRun]:
    kept = _kept(run, shortest)
    if kept == [_whole(run)]:
        return [run]
    return [_piece(run, span, f", part {k + 1}" if k else "") for k, span in enumerate(kept)]


def _kept(run: RecordedRun, shortest: float) -> list[slice]:
    long = [span for span in _spans(run) if _lasts(run, span) >= shortest]
    worth = sum(s.stop - s.start for s in long) >= WORTH * run.time.size
    return long if worth else [_whole(run)]


def _spans(run: RecordedRun) -> list[slice]:
    cuts = (gaps(run.time) + 1).tolist()
    return [slice(a, b) for a, b in zip([0, *cuts], [*cuts, run.time.size], strict=True)]


def _whole(run: RecordedRun) -> slice:
    return slice(0, run.time.size)


def _lasts(run: RecordedRun, span: slice) -> float:
    return float(run.time[span.stop - 1] - run.time[span.start])


def _piece(run: RecordedRun, span: slice, part: str) -> RecordedRun:
    # A part is no repetition of the others.
    rows = run.row(span.start), run.row(span.stop - 1) + 1
    return replace(
        run.only(span), name=run.name + part, experiment=run.experiment + part, rows=rows,
        cut_from=name_of_whole(run),
    )  # fmt: skip
