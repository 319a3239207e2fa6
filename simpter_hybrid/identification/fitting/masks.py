"""Samples that say nothing about a model: the instant of a jump is a sample early or late."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..recordings.smoothing import centred
from .replay import Replay

#: A predicted change of the transmitted torque by this many standard deviations from one sample
#: to the next is a jump (breakaway or stop), not a transient of the excitation.
JUMP = 20.0
#: Samples left out on either side.
AROUND = 4


def without_jumps(
    replays: Sequence[Replay], predicted: Sequence[np.ndarray], channel: str
) -> list[Replay]:
    """Replays without the samples around jumps of the predicted `channel`."""
    found = []
    for replay, values in zip(replays, predicted, strict=True):
        seen = replay.observed.get(channel)
        if seen is None:
            found.append(replay)
            continue
        jump = np.abs(np.diff(values, prepend=values[0])) > JUMP * seen.sd
        calm = ~widened(jump, AROUND)
        observed = {c: replace(o, keep=o.keep & calm) for c, o in replay.observed.items()}
        found.append(replace(replay, observed=observed))
    return found


def widened(marked: np.ndarray, samples: int) -> np.ndarray:
    """`marked` and its neighbours up to `samples` away."""
    return centred(marked, np.ones(2 * samples + 1)) > 0.5
