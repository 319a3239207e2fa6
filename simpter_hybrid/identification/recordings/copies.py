"""Runs that are in a recording twice: a copy is no repetition, and none that was held out."""

from __future__ import annotations

import numpy as np

from ...problems import Problems
from .recording import Recording

#: Fewest different values of a sensor that no two runs have alike by chance.
DIFFERENT = 20


def refuse_copies(recording: Recording) -> None:
    """Check that no run holds to the last digit what another one does.

    Of a run in which no sensor shows many values nothing is said: it rests, or a coarse one hardly
    moves.

    Raises
    ------
    InvalidInput
        With all runs that do.
    """
    first: dict[tuple[tuple[str, bytes], ...], str] = {}
    problems = Problems(recording.source)
    measured = [n for n, c in recording.channels.items() if c.role == "measured"]
    for run in recording.runs:
        seen = [run.channels[n] for n in measured if n in run.channels]
        if max((np.unique(values).size for values in seen), default=0) < DIFFERENT:
            continue
        held = [("", run.time - run.time[0]), *sorted(run.channels.items())]
        known = first.setdefault(tuple((n, v.tobytes()) for n, v in held), run.name)
        if known != run.name:
            right = "every run once; one that was repeated has noise of its own"
            problems.add((run.name,), f"the same rows as in {known}", "a copy", right)
    problems.raise_if_any()
