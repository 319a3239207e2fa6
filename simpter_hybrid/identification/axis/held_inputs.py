"""How what drives an axis, and what presses it, goes on between rows of its record."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from ..fitting.replay import Replay
from ..recordings.recording import RecordedRun, Recording

#: How an input goes on between its samples; of a drive in a replay's input ``holds``.
HOLDS = {"before": -1.0, "sampled": 0.0, "after": 1.0}
#: Rows from which on a curve through them has slopes.
LEAST = 3
#: Input of a replay that says so of what presses; smooth through its rows without it.
PRESS_HOLDS = "press holds"


def between(instants: np.ndarray, time: np.ndarray, values: np.ndarray, holds: float) -> np.ndarray:
    """Values of a sampled input at instants between its rows; `holds` is one of `HOLDS`.

    What is not held goes smoothly through the rows: straight from row to row the force of a servo
    that catches a falling mass was off by so much that runs of a right model were not noise.
    """
    if holds == HOLDS["sampled"]:
        if values.size < LEAST:
            return np.interp(instants, time, values)
        smooth = CubicHermiteSpline(time, values, np.gradient(values, time))
        return smooth(np.clip(instants, time[0], time[-1]))
    row = np.searchsorted(time, instants, side="right") - (holds == HOLDS["after"])
    return values[np.clip(row, 0, values.size - 1)]


def presses(replay: Replay) -> float:
    """How the pressing input goes on between its rows: one of `HOLDS`."""
    held = replay.inputs.get(PRESS_HOLDS)
    return HOLDS["sampled"] if held is None else float(held[0])


def pressing(run: RecordedRun, recording: Recording, name: str) -> dict[str, np.ndarray]:
    """Pressing input of the friction surfaces (samples,), and how it goes on between rows."""
    ones = np.ones(run.time.size)
    held = recording.channels[name].held if name in run.channels else "sampled"
    return {"press": run.channels.get(name, 0.0 * ones), PRESS_HOLDS: HOLDS[held] * ones}
