"""That what is left swings at one frequency in several runs, which is no friction."""

from __future__ import annotations

import numpy as np

from ..fitting.fitted_model import Model
from ..found import Found
from ..reported import Reported
from ..tracing.swings import Line, lines_of, same_line

#: Runs that are listed.
LISTED = 3


def swinging_sentence(found: Found, told: Reported) -> str:
    """At which frequency what the corrected model leaves swings, and in which runs; "" if none."""
    done = found.diagnosis
    if done.verdict.kind in ("nothing missing", "effect"):
        return ""
    model: Model = done.corrected
    lines: dict[str, Line] = {}
    for replays in (found.split.fit, found.split.select):
        lines |= lines_of(replays, model.predictor.predict(model.values, replays))
    lines |= lines_of(told.replays, told.after)
    runs = same_line(lines)
    if not runs:
        return ""
    frequency = float(np.mean([lines[run].frequency for run in runs]))
    more = f" and {len(runs) - LISTED} more runs" if len(runs) > LISTED else ""
    parts = [100.0 * lines[run].part for run in runs]
    return (
        f"In {', '.join(runs[:LISTED])}{more} what is left swings at {frequency:.3g} Hz, whatever "
        f"the motion does ({min(parts):.0f} to {max(parts):.0f} % of its mean square): an elastic "
        "part (a rod, a belt, a mount), a loop that rings, or mains. That is not friction."
    )
