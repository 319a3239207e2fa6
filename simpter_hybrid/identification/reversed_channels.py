"""A sign that a map has wrong: recorded channels turned round, one at a time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from .predictor import Predictor
from .replay import Replay
from .residual import rms, weighted_residuals

#: A sign is doubted where the other leaves less than this part of the error: no sensor or force
#: that is recorded rightly could be turned round and be explained twice as well.
HALF = 0.5


def better_reversed(
    predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
) -> dict[str, float]:
    """Channels that the model explains better with the other sign -> part of the error left.

    Channels that are never negative (commands, counts) are not asked.
    """
    error = rms(weighted_residuals(predictor, values, replays))
    found = {}
    for name in dict.fromkeys(n for r in replays for n in (*r.inputs, *r.observed)):
        recorded = [_values(r, name) for r in replays]
        if all(np.all(~(v < 0.0)) for v in recorded if v is not None):
            continue
        turned = [_turned(replay, name) for replay in replays]
        left = rms(weighted_residuals(predictor, values, turned)) / error if error > 0.0 else 1.0
        if left < HALF:
            found[name] = left
    return dict(sorted(found.items(), key=lambda item: item[1]))


def _values(replay: Replay, name: str) -> np.ndarray | None:
    if name in replay.inputs:
        return replay.inputs[name]
    return replay.observed[name].values if name in replay.observed else None


def _turned(replay: Replay, name: str) -> Replay:
    inputs, observed = dict(replay.inputs), dict(replay.observed)
    if name in inputs:
        inputs[name] = -inputs[name]
    if name in observed:
        observed[name] = replace(observed[name], values=-observed[name].values)
    return replace(replay, inputs=inputs, observed=observed)
