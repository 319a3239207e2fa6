"""Whether a declared model acts often enough for a record to be played by it."""

from __future__ import annotations

import numpy as np

from ..problems import Problems
from ..scenario import Scenario
from .recordings.checks import Finding
from .recordings.recording import Recording
from .recordings.row_step import row_step
from .tip.smooth_force import SMOOTHED

#: A model's controller may act at so many times the interval of the samples: slower, it loses what
#: moved the rig.
COARSE = 1.5
#: Longest time between two commands of a device with a tip [s].  Its controller may be slower than
#: its rows by far: the thesis's ran at 30 Hz.
SLOWEST_TICKS = 0.1


def check_rate(recording: Recording, declared: Scenario) -> None:
    """Check that a record is played about as finely as it was sampled.

    Raises
    ------
    InvalidInput
        If the model's rate is far lower: most of what drives it would be lost.
    """
    step = usual_step(recording)
    if declared.period > COARSE * step:
        _refuse(declared, f"at least the {1.0 / step:.4g} Hz of its samples")


def check_ticks(recording: Recording, declared: Scenario) -> None:
    """Check the same of a device with a tip, whose commands change at the model's rate alone.

    Raises
    ------
    InvalidInput
        If that is so low that commands would act at other times than they did.
    """
    if declared.period > max(COARSE * usual_step(recording), SLOWEST_TICKS):
        least = f"at least {1.0 / SLOWEST_TICKS:g} Hz"
        _refuse(declared, f"{least}: that at which commands could change as this was recorded")


def late_ticks(recording: Recording, declared: Scenario) -> tuple[Finding, ...]:
    """A remark where commands are played at instants farther apart than forces are smoothed."""
    if declared.period <= max(COARSE * usual_step(recording), SMOOTHED):
        return ()
    what = "commands and tip force are played at the model's rate, coarser than the rows"
    right = "that at which commands could change as this was recorded"
    return (Finding.of_all(what, f"{1.0 / declared.period:.4g} Hz", right),)


def usual_step(recording: Recording) -> float:
    """The usual time between rows [s]."""
    return float(np.median([row_step(run.time) for run in recording.runs]))


def _refuse(declared: Scenario, right: str) -> None:
    problems = Problems(declared.name)
    got, what = f"{1.0 / declared.period:.4g} Hz", "the record would be played too coarsely"
    problems.add(("controller", "rate"), what, got, right, where=declared.name)
    problems.raise_if_any()
