"""That what is left swings at one frequency in several runs, which is hardly friction."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..fitting.fitted_model import Model
from ..fitting.replay import Replay
from ..held_out_predictions import HeldOutPredictions
from ..recordings.row_step import row_step
from ..result import Diagnosis
from ..tracing.named import balance_of
from ..tracing.ringing import RINGING
from ..tracing.swings import Line, lines_of, of_the_motion, same_line
from .recorded_speeds import recorded_speeds

#: Runs that are listed.
LISTED = 3
HARDLY = "sliding friction would hardly do that"


def swinging_sentence(found: Diagnosis, told: HeldOutPredictions) -> str:
    """Sentence on the frequency at which what is left swings in several runs; "" without one.

    Only of recorded motions, and where these do not do it themselves.
    """
    done = found.search
    if done.verdict.kind in ("nothing missing", "effect"):
        return ""
    model: Model = done.corrected
    lines: dict[str, Line] = {}
    for replays in (found.split.fit, found.split.select):
        lines |= _own_lines(replays, model.predictor.predict(model.values, replays))
    lines |= _own_lines(told.replays, told.after)
    runs = same_line(lines)
    if not runs:
        return ""
    frequency = float(np.mean([lines[run].frequency for run in runs]))
    parts = [100.0 * lines[run].part for run in runs]
    gives = any(balance_of(c) == RINGING for c in done.verdict.coordinates)
    friction = "bristles that ring after a breakaway do so too" if gives else HARDLY
    more = f" and {len(runs) - LISTED} more runs" if len(runs) > LISTED else ""
    return (
        f"In {', '.join(runs[:LISTED])}{more} what is left swings at {frequency:.3g} Hz, at which "
        f"the motion does not repeat itself ({min(parts):.0f} to {max(parts):.0f} % of its mean "
        "square): an elastic part (a rod, a belt, a mount, surfaces before they slip), a loop that "
        "rings, or mains; "
        f"{friction}."
    )


def _own_lines(
    replays: Sequence[Replay], predicted: Mapping[str, Sequence[np.ndarray]]
) -> dict[str, Line]:
    """Lines in what is left of each run, without those that its own motion makes."""
    found = lines_of(replays, predicted)
    for replay in replays:
        if (line := found.get(replay.name)) is None:
            continue
        step = row_step(replay.time)
        speeds = recorded_speeds(replay)
        if not speeds or any(of_the_motion(line.frequency, v, step) for v in speeds):
            del found[replay.name]
    return found
