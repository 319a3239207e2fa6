"""Runs held out of which a few windows hold what their error is above that of those that select.

Where a little decides whether a device sticks at a turn, a model that is right but for that little
sticks where the rig moved on: such a window is as wrong as one of a model that lacks an effect.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..fitting.residual import compared_only_where_predicted as of_told
from ..fitting.residual import residual_parts
from ..held_out_predictions import HeldOutPredictions
from ..result import Diagnosis
from .held_out_sentences import held_out, most_carried_over

#: Few is up to this part of all windows.
FEW = 0.05
#: Windows are listed up to so many.
LISTED = 3


class Window(NamedTuple):
    """Sum of squares and number of a window's weighted residuals; where it is."""

    squares: float
    samples: int
    run: str
    time: float


def few_windows_sentence(found: Diagnosis, told: HeldOutPredictions) -> str:
    """Sentence on few windows that make the runs held out worse than others; "" if none do."""
    limit = most_carried_over(found)
    if held_out(found) <= limit:
        return ""
    windows = sorted(_windows(told), reverse=True)
    for count in range(1, int(FEW * len(windows)) + 1):
        rest = windows[count:]
        left = float(np.sqrt(sum(w.squares for w in rest) / sum(w.samples for w in rest)))
        if left <= limit * found.floors.report:
            where = ", ".join(f"{w.run} from {w.time:.4g} s" for w in windows[:LISTED][:count])
            more = f" and {count - LISTED} more" if count > LISTED else ""
            rest_is = "the rest shows no more than the runs that select do"
            if _right(found, left / found.floors.report):
                rest_is = "nothing more need be missing"
            return (
                f"Without {count} of {len(windows)} windows ({where}{more}) the error of the runs "
                f"held out is {left / found.floors.report:.2f} times the floor. Look at these: if "
                "the model sticks there and the rig moves on, or the other way round, less than "
                f"its parameters are known to decides it, and {rest_is}."
            )
    return ""


def _right(found: Diagnosis, left: float) -> bool:
    """Whether what the windows leave `left`, over the floor, and all that selects is noise."""
    done, limits = found.search, found.limits
    limit = limits.form if done.corrected.effects else limits.lack
    return max(left, done.corrected.select_error / done.floor) <= limit


def _windows(told: HeldOutPredictions) -> Iterator[Window]:
    """Every window that is compared, with what the corrected model leaves in it."""
    compared = of_told(told.after, told.replays)
    for channel, i, residuals in residual_parts(told.after, compared):
        replay = compared[i]
        seen = replay.observed.get(channel)
        if seen is None or not seen.windows:
            continue
        starts = np.array(seen.windows)
        window = np.searchsorted(starts, np.flatnonzero(seen.keep), side="right") - 1
        for k in np.unique(window):
            here = residuals[window == k]
            yield Window(float(here @ here), here.size, replay.name, float(replay.time[starts[k]]))
