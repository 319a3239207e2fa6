"""Runs that were broken off: a few rows that tell nothing are left out, and told."""

from __future__ import annotations

from collections.abc import Sequence

from .checks import FEWEST, Finding
from .columns import Columns
from .map_file import RecordingMap
from .runs import RunSpan

#: Runs that hold together more than this part of all rows are no runs that were broken off: the
#: map has a run end where none does.
MOST = 0.1


def without_broken_off(
    runs: Sequence[RunSpan], columns: Columns, described: RecordingMap
) -> tuple[list[RunSpan], list[Finding]]:
    """The runs that have enough rows, and a remark on each that has not.

    All of them, without a remark, where those are too many to have been broken off: each is then
    refused by itself.
    """
    short = [run for run in runs if _rows(run) < FEWEST]
    if sum(map(_rows, short)) > MOST * sum(map(_rows, runs)):
        return list(runs), []
    right = f"left out; at least {FEWEST} rows tell something"
    told = [
        Finding(
            run.name, "a run of a few rows", str(_rows(run)), right, run.rows[0],
            float(described.stamps(columns.numbers, run.rows)[0]),
        )
        for run in short
    ]  # fmt: skip
    return [run for run in runs if run not in short], told


def _rows(run: RunSpan) -> int:
    return run.rows[1] - run.rows[0]
