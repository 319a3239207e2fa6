"""Runs of which rows are missing, cut where they are: nothing predicts across what was not seen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .recording import RecordedRun, Recording
from .recording_checks import gaps

#: A run is cut where what is long enough still holds this part of its samples.
WORTH = 0.5


def cut_at_gaps(recording: Recording, shortest: float) -> Recording:
    """The recording with runs that end at a gap of time, and go on behind it as runs of their own.

    Parameters
    ----------
    recording : Recording
    shortest : float
        Pieces that last less are left out [s], unless they are most of the run: a run of many short
        pieces stays whole.
    """
    runs = [piece for run in recording.runs for piece in _pieces(run, shortest)]
    return replace(recording, runs=tuple(runs))


def _pieces(run: RecordedRun, shortest: float) -> list[RecordedRun]:
    cuts = gaps(run.time) + 1
    if not cuts.size:
        return [run]
    spans = zip([0, *cuts], [*cuts, run.time.size], strict=True)
    kept = [slice(a, b) for a, b in spans if run.time[b - 1] - run.time[a] >= shortest]
    if sum(s.stop - s.start for s in kept) < WORTH * run.time.size:
        return [run]
    return [_piece(run, span) for span in kept]


def _piece(run: RecordedRun, span: slice) -> RecordedRun:
    rows = run.rows[0] + int(span.start), run.rows[0] + int(span.stop)
    channels = {name: values[span] for name, values in run.channels.items()}
    name = f"{run.name} from {run.time[span.start]:g} s" if span.start else run.name
    return replace(run, name=name, rows=rows, time=np.array(run.time[span]), channels=channels)
