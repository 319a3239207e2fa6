"""What a model is given of a run's record, kept: a fit asks for the same hundreds of times."""

from __future__ import annotations

import numpy as np

from ..fitting.replay import Replay
from .rig import Rig

#: What the notes of a replay say of how it moves, which is no part of what drives it.
MOTION = ("start", "states", "position", "speed", "acceleration")


def packed(
    rig: Rig, replay: Replay, period: float, staged: bool | None
) -> tuple[float, np.ndarray]:
    """How often a run's record is played [s], and what of it is.

    Parameters
    ----------
    rig : Rig
    replay : Replay
        Its memo keeps the answer, with all that this is of.
    period : float
        Of the model's controller [s].
    staged : bool or None
        Whether stages follow what plays it; None where the record is played at that period anyhow.
    """
    key = (period, staged, *replay.observed, *replay.notes)
    notes = (note for name, note in replay.notes.items() if name not in MOTION)
    of = (rig, replay.time, replay.inputs, *notes)
    kept = replay.memo.get(key)
    if kept and all(x is y for x, y in zip(kept[0], of, strict=True)):
        return kept[1]
    played = period if staged is None else rig.period(replay, period, staged)
    made = played, rig.pack(replay, played)
    replay.memo[key] = of, made
    return made
