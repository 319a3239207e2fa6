"""Angles that begin anew after a turn, made to go on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...problems import Problems
from .columns import Columns
from .map_file import RecordingMap
from .runs import RunSpan
from .stretches import stretches

#: Part of a turn by which a column may go beyond it.
BEYOND = 0.02
#: Rows by which a rate is told, and the steps of time, in usual ones, over which it is asked for.
ROWS, LOST = 5, 1.5


def unwrapped(runs: Sequence[RunSpan], columns: Columns, described: RecordingMap) -> Columns:
    """Columns that go on where those of the file begin anew, in each run from its first row.

    Pieces of a run go on from one to the next.  Over lost rows they go on as fast as before them.

    Raises
    ------
    InvalidInput
        If a column goes on beyond what it is said to begin anew after.
    """
    numbers, problems = dict(columns.numbers), Problems(described.source)
    wrapped = [(s, c) for s, c in described.channels.items() if c.wraps > 0.0]
    for signal, channel in wrapped:
        values = numbers[channel.column].copy()  # of which other rows may be another channel's
        turn = abs(channel.wraps / channel.scale)
        for run in {run.whole.rows: run.whole for run in runs}.values():
            rows = slice(*run.rows)
            told = np.isfinite(values[rows]) & columns.applies(channel, run.rows)
            seen = values[rows][told]
            if seen.size and float(seen.max() - seen.min()) > (1.0 + BEYOND) * turn:
                got = f"{channel.written_size(channel.wraps)}, in {run.name}"
                right = "what the column begins anew after; of one that goes on no such key"
                what = "the column goes on beyond that"
                problems.add(("channels", signal, "wraps"), what, got, right)
                break
            time = described.stamps(columns.numbers, run.rows)
            for stretch in stretches(told):
                values[rows][stretch] = gone_on(time[stretch], values[rows][stretch], turn)
        numbers[channel.column] = values
    problems.raise_if_any()
    return replace(columns, numbers=numbers) if wrapped else columns


def gone_on(time: np.ndarray, values: np.ndarray, turn: float) -> np.ndarray:
    """Values of one stretch that go on beyond a turn (rows,).

    Parameters
    ----------
    time, values : ndarray (rows,)
        Stamps [s], and numbers of the column.
    turn : float
        What they begin anew after.
    """
    found = np.unwrap(values, period=turn)
    steps = np.diff(time)
    if not (steps > 0.0).all():  # which is refused by itself
        return found
    for k in np.flatnonzero(steps > LOST * np.median(steps)).tolist():
        first = max(0, k - ROWS)
        rate = (found[k] - found[first]) / (time[k] - time[first]) if k > first else 0.0
        off = found[k] + rate * steps[k] - found[k + 1]
        found[k + 1 :] += turn * np.round(off / turn)
    return found
