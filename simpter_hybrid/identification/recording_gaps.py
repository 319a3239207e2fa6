"""Runs of which rows are missing, cut where they are: nothing predicts across what was not seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from .recording import RecordedRun, Recording
from .recording_checks import gaps

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


def _pieces(run: RecordedRun, shortest: float) -> list[RecordedRun]:
    cuts = gaps(run.time) + 1
    if not cuts.size:
        return [run]
    spans = zip([0, *cuts], [*cuts, run.time.size], strict=True)
    kept = [slice(a, b) for a, b in spans if run.time[b - 1] - run.time[a] >= shortest]
    if sum(s.stop - s.start for s in kept) < WORTH * run.time.size:
        return [run]
    return [_piece(run, span, f", part {k + 1}" if k else "") for k, span in enumerate(kept)]


def _piece(run: RecordedRun, span: slice, part: str) -> RecordedRun:
    # A part is no repetition of the others.
    rows = run.rows[0] + int(span.start), run.rows[0] + int(span.stop)
    channels = {name: values[span] for name, values in run.channels.items()}
    return replace(
        run, name=run.name + part, experiment=run.experiment + part, rows=rows,
        time=np.array(run.time[span]), channels=channels,
    )  # fmt: skip
