"""Runs that are in a recording twice: a copy is no repetition, and none that was held out."""

from __future__ import annotations

from collections.abc import Sequence

from ...problems import Problems
from .map_file import RecordingMap
from .recorded_run import RecordedRun


def refuse_copies(runs: Sequence[RecordedRun], described: RecordingMap, source: str) -> None:
    """Raise InvalidInput with all runs whose sensors tell to the last digit what another's do.

    What rests throughout may: of those nothing is said.
    """
    measured = [n for n, c in described.channels.items() if c.role == "measured"]
    first: dict[tuple[tuple[str, bytes], ...], str] = {}
    problems = Problems(source)
    for run in runs:
        seen = {n: run.channels[n] for n in measured if n in run.channels}
        if not any((values != values[0]).any() for values in seen.values()):
            continue
        known = first.setdefault(tuple((n, v.tobytes()) for n, v in seen.items()), run.name)
        if known != run.name:
            right = "every run once; one that was repeated has noise of its own"
            problems.add((run.name,), f"the same measurements as in {known}", "a copy", right)
    problems.raise_if_any()
