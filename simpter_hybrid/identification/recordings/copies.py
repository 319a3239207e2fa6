"""Runs that are in a recording twice: a copy is no repetition, and none that was held out."""

from __future__ import annotations

from ...problems import Problems
from .recording import Recording


def refuse_copies(recording: Recording) -> None:
    """Raise InvalidInput with all runs whose sensors tell to the last digit what another's do.

    What rests throughout may: of those nothing is said.
    """
    measured = [n for n, c in recording.channels.items() if c.role == "measured"]
    first: dict[tuple[tuple[str, bytes], ...], str] = {}
    problems = Problems(recording.source)
    for run in recording.runs:
        seen = {n: run.channels[n] for n in measured if n in run.channels}
        if not any((values != values[0]).any() for values in seen.values()):
            continue
        known = first.setdefault(tuple((n, v.tobytes()) for n, v in seen.items()), run.name)
        if known != run.name:
            right = "every run once; one that was repeated has noise of its own"
            problems.add((run.name,), f"the same measurements as in {known}", "a copy", right)
    problems.raise_if_any()
