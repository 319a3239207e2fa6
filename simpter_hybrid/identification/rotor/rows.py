"""A rotor's recording at the rate of rows for which its breakaways are looked for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..recordings.checks import Finding
from ..recordings.recorded_run import RecordedRun
from ..recordings.recording import Recording

#: Time between rows [s]: slips, stops and levels are judged by some rows of this length.
ROW = 2e-3
#: Part of a row by which its time may be off.
ROUNDING = 1e-3
FAST = "rows come faster than a rotor needs"


def as_rotor(recording: Recording) -> Recording:
    """The recording with every second, third ... row left out where they come faster than `ROW`."""
    every = [_every(run) for run in recording.runs]
    if max(every) == 1:
        return recording
    runs = tuple(_thinned(run, k) for run, k in zip(recording.runs, every, strict=True))
    first, k = next((run, k) for run, k in zip(runs, every, strict=True) if k > 1)
    right = f"about {ROW:g} s; an edge of the command is known to a row"
    told = Finding(first.name, FAST, f"one of {k} is used", right, -1, np.nan)
    return replace(recording, runs=runs, findings=(*recording.findings, told))


def fast_rows(recording: Recording) -> tuple[Finding, ...]:
    """What `as_rotor` has to tell."""
    return tuple(f for f in recording.findings if f.what == FAST)


def _every(run: RecordedRun) -> int:
    return max(1, int(ROUNDING + ROW / float(np.median(np.diff(run.time)))))


def _thinned(run: RecordedRun, every: int) -> RecordedRun:
    if every == 1:
        return run
    channels = {name: values[::every] for name, values in run.channels.items()}
    outliers = {name: marked[::every] for name, marked in run.outliers.items()}
    return replace(run, time=run.time[::every], channels=channels, outliers=outliers)
