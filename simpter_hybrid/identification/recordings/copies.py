"""Runs that are in a recording twice: a copy is no repetition, and none that was held out."""

from __future__ import annotations

import numpy as np

from ...problems import Problems
from .recorded_run import RecordedRun
from .recording import Recording
from .row_step import row_step

#: Fewest different values of a sensor that no two runs have alike by chance.
DIFFERENT = 20
#: Part of a row by which stamps of the same rows may differ from their runs' first ones: those that
#: count on from run to run are other floats.
ROUNDING = 1e-3


def refuse_copies(recording: Recording) -> None:
    """Check that no run holds to the last digit what another one does.

    Of a run in which no sensor shows many values nothing is said: it rests, or a coarse one hardly
    moves.

    Raises
    ------
    InvalidInput
        With all runs that do.
    """
    alike: dict[tuple[tuple[str, bytes], ...], list[RecordedRun]] = {}
    problems = Problems(recording.source)
    measured = [n for n, c in recording.channels.items() if c.role == "measured"]
    for run in recording.runs:
        seen = [run.channels[n] for n in measured if n in run.channels]
        if max((np.unique(values).size for values in seen), default=0) < DIFFERENT:
            continue
        held = tuple((n, v.tobytes()) for n, v in sorted(run.channels.items()))
        others = alike.setdefault(held, [])
        known = next((other for other in others if _at_the_same_instants(run, other)), None)
        if known is None:
            others.append(run)
        else:
            right = "every run once; one that was repeated has noise of its own"
            problems.add((run.name,), f"the same rows as in {known.name}", "a copy", right)
    problems.raise_if_any()


def _at_the_same_instants(run: RecordedRun, other: RecordedRun) -> bool:
    """Whether two runs of as many rows have them at the same instants since their first ones."""
    apart = (run.time - run.time[0]) - (other.time - other.time[0])
    return bool(np.abs(apart).max() < ROUNDING * row_step(run.time))
