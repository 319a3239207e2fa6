"""Pauses of a recorder so long that what is behind one is a run of its own.

A run with short gaps is replayed through them.  Through an hour it would take longer than all of
its rows do, and nobody knows what happened in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ..recordings.checks import FEWEST, Finding
from ..recordings.gaps import WORTH
from ..recordings.recorded_run import RecordedRun
from ..recordings.recording import Recording
from ..recordings.row_step import row_step
from ..recordings.runs import name_of_whole

#: A pause is long from so many seconds on, or if so many rows are missing.
LONG, ROWS = 600.0, 200_000


def cut_at_long_pauses(recording: Recording) -> Recording:
    """A recording whose runs end at a long pause, and go on behind it as runs of their own.

    They keep their group.  Pieces of a few rows are left out, unless they are most of the run:
    such a run stays whole.
    """
    pieces, remarks = list[RecordedRun](), list[Finding]()
    for run in recording.runs:
        spans = _spans(run)
        long = [span for span in spans if span.stop - span.start >= FEWEST]
        kept = sum(span.stop - span.start for span in long)
        if len(spans) == 1 or kept < WORTH * run.time.size:
            pieces.append(run)
            continue
        pieces += [_piece(run, span, number) for number, span in enumerate(long)]
        remarks.append(_cut(run, spans, len(spans) - len(long)))
    if not remarks:
        return recording
    return replace(recording, runs=tuple(pieces), findings=(*recording.findings, *remarks))


def _spans(run: RecordedRun) -> Sequence[slice]:
    long = np.flatnonzero(np.diff(run.time) > _longest(run)) + 1
    return [slice(a, b) for a, b in pairwise([0, *long.tolist(), run.time.size])]


def _longest(run: RecordedRun) -> float:
    return min(LONG, ROWS * row_step(run.time))


def _cut(run: RecordedRun, spans: Sequence[slice], short: int) -> Finding:
    """What a reader should know of a run that was cut."""
    begun = [span.start for span in spans[1:]]
    last = max(begun, key=lambda k: run.time[k] - run.time[k - 1])
    left = f"; what has under {FEWEST} rows is left out ({short} of the pieces)" if short else ""
    return Finding(
        run.name, "a long pause, behind which a run of its own begins",
        f"{run.time[last] - run.time[last - 1]:.4g} s",
        f"at most {_longest(run):.4g} s; a column in the map's [runs] boundaries may name what is "
        f"behind{left}",
        run.rows[0] + last, float(run.time[last]),
    )  # fmt: skip


def _piece(run: RecordedRun, span: slice, number: int) -> RecordedRun:
    # Behind a pause it is no repetition of what was before.
    part = f", part {number + 1}" if number else ""
    rows = run.rows[0] + span.start, run.rows[0] + span.stop
    return replace(
        run.only(span), name=run.name + part, experiment=run.experiment + part, rows=rows,
        cut_from=name_of_whole(run),
    )  # fmt: skip
