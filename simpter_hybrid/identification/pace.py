"""How far a model goes for each step of the record, where straight lines count for nothing.

Of positions alone a window's start has a speed that is known badly, and of a straight line in what
is left half of the way is forgiven.  Starts err either way: a model that goes slower than the
record in window after window is wrong itself, and its error says nothing of that.  Where it rests
it goes at no pace (`reporting.creeping`).
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from .held_out_predictions import HeldOutPredictions, held_out_predictions
from .result import Diagnosis
from .untested import untested
from .window_ways import window_ways

#: Fewest windows in which the record goes far.
FEWEST = 8
#: A pace is told that is off by so much, and by so many standard errors.
OFF, ERRORS = 0.1, 4.0


class OtherPace(NamedTuple):
    """Way of a model for each of the record, and its standard error, in so many windows."""

    channel: str
    windows: int
    pace: float
    error: float


def other_pace(told: HeldOutPredictions) -> OtherPace | None:
    """The pace of a corrected model that goes another way than the record; None if it does not."""
    for channel in dict.fromkeys(c for replay in told.replays for c in replay.observed):
        ways = np.array(
            [
                (way.gone, way.went)
                for i, replay in enumerate(told.replays)
                if channel in replay.observed
                for way in window_ways(replay.observed[channel], told.after[channel][i])
                if way.far and np.isfinite(way.went) and not way.rests
            ]
        ).reshape(-1, 2)
        if len(ways) < FEWEST:
            continue
        pace, error = pace_of(*ways.T)
        if abs(pace - 1.0) > max(OFF, ERRORS * error):
            return OtherPace(channel, len(ways), pace, error)
    return None


def not_cleared_at_another_pace(found: Diagnosis) -> Diagnosis:
    """The diagnosis whose all-clear is none where its error says nothing of the model's pace.

    Nor is it one then that nearly every model would do as well.
    """
    seen = (one for replay in found.split.report for one in replay.observed.values())
    # Only where straight lines are taken are the runs held out simulated for it.
    if not _near_the_floor(found) or not any(one.lines and one.windows for one in seen):
        return found
    if other_pace(held_out_predictions(found)) is None:
        return found
    done = found.search
    unsure = replace(done, verdict=replace(done.verdict, kind="lack or noise"))
    return replace(found, search=unsure, off_pace=True)


def _near_the_floor(found: Diagnosis) -> bool:
    """Whether the verdict is an all-clear, or is none only because the runs test no model."""
    done = found.search
    near = done.corrected.select_error <= found.limits.lack * done.floor
    no_test = near and untested(found.remarks) is not None
    kind = done.verdict.kind
    return kind == "nothing missing" or (kind == "lack or noise" and no_test)


def pace_of(seen: np.ndarray, model: np.ndarray) -> tuple[float, float]:
    """Way of the model for each of the record, and its standard error.

    Parameters
    ----------
    seen, model : ndarray (windows,)
        How far they go [SI].
    """
    square, both = float(seen @ seen), float(model @ seen)
    # Without each window in turn: one that goes far fits itself.
    without = (both - model * seen) / (square - seen**2)
    count = seen.size
    return both / square, float(np.sqrt((count - 1) * np.var(without)))
