"""The replicate floor: what no model of these runs could predict.

Two runs with the same inputs differ by noise alone (and by what scatters: breakaway).  Half the
variance of their difference is the variance of one run about what is common to both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from .replay import Observation, Replay
from .residual import CLIP

#: Breakaways of two replicates this many samples apart or less are the same one.
SAME_BREAKAWAY = 100


class Floors(NamedTuple):
    """Error of a perfect model on the runs that fit, select and report, in standard deviations.

    One motion lets noise of what drives it move a prediction further than another.
    """

    fit: float
    select: float
    report: float


def same_inputs(a: Replay, b: Replay) -> bool:
    """Whether two runs had the same time stamps and inputs, so that one replay serves both.

    And measured the same channels.  What was logged beside may have an effect: a run that was
    warmer all through is another one.
    """
    return (
        a.told
        and b.told
        and a.experiment == b.experiment
        and a.setting == b.setting
        and a.time.size == b.time.size
        and np.allclose(a.time, b.time, rtol=0, atol=1e-9)
        and a.inputs.keys() == b.inputs.keys()
        and all(np.array_equal(a.inputs[k], b.inputs[k]) for k in a.inputs)
        and a.observed.keys() == b.observed.keys()
        and same_beside(a, b)
    )


def same_beside(a: Replay, b: Replay) -> bool:
    """Whether what was logged beside two runs had values in common, channel by channel."""
    return all(_overlap(a.logged[k], b.logged[k]) for k in a.logged.keys() & b.logged.keys())


def _overlap(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two courses have values in common; those that say nothing have."""
    known = [x[np.isfinite(x)] for x in (one, other)]
    if not all(x.size for x in known):
        return True
    return bool(max(x.min() for x in known) <= min(x.max() for x in known))


def merged(replays: Sequence[Replay]) -> list[Replay]:
    """Replicates without restarts replaced by their mean: as much information, half the cost."""
    groups: list[list[Replay]] = []
    for replay in replays:
        for group in groups:
            if not replay.restarts and not group[0].restarts and same_inputs(group[0], replay):
                group.append(replay)
                break
        else:
            groups.append([replay])
    return [_mean(group) for group in groups]


def _mean(group: Sequence[Replay]) -> Replay:
    if len(group) == 1:
        return group[0]
    observed = {}
    for channel, first in group[0].observed.items():
        values = np.mean([r.observed[channel].values for r in group], axis=0)
        keep = np.all([r.observed[channel].keep for r in group], axis=0)
        observed[channel] = Observation(values, first.sd, keep, first.weight, own=first.own)
    name = f"{group[0].name} (mean of {len(group)})"
    in_all = [c for c in group[0].logged if all(c in r.logged for r in group)]
    logged = {c: np.mean([r.logged[c] for r in group], axis=0) for c in in_all}
    return replace(group[0], name=name, observed=observed, replicates=len(group), logged=logged)


def replicate_pairs(replays: Sequence[Replay]) -> list[tuple[Replay, Replay]]:
    """Pairs of runs with the same inputs, each run in at most one pair."""
    pairs, left = [], list(replays)
    while left:
        first = left.pop(0)
        match = next((r for r in left if same_inputs(first, r)), None)
        if match is not None:
            left.remove(match)
            pairs.append((first, match))
    return pairs


def replicate_floor(replays: Sequence[Replay]) -> dict[str, float]:
    """Root mean square per channel [SI] that replicates leave: no model can do better.

    Channels without replicates are left out; ``breakaway`` is relative.
    """
    square: dict[str, float] = {}
    count: dict[str, int] = {}
    for a, b in replicate_pairs(replays):
        for channel, seen in a.observed.items():
            other = b.observed[channel]
            keep = seen.keep & other.keep
            error = (seen.values - other.values)[keep]
            square[channel] = square.get(channel, 0.0) + float(error @ error) / 2
            count[channel] = count.get(channel, 0) + error.size
        for x, y in zip(a.breakaways, b.breakaways, strict=False):
            change = 2 * (x.level - y.level) / (abs(x.level) + abs(y.level))
            if abs(x.index - y.index) < SAME_BREAKAWAY:  # the same breakaway, not another one
                square["breakaway"] = square.get("breakaway", 0.0) + change**2 / 2
                count["breakaway"] = count.get("breakaway", 0) + 1
    return {c: float(np.sqrt(square[c] / count[c])) for c in square if count[c]}


def noise_floor(replays: Sequence[Replay]) -> float:
    """What a perfect model would score if noise of the sensors were all: see `Observation.own`."""
    seen = [o for r in replays for o in r.observed.values()]
    squares = [int(o.keep.sum()) * (o.weight * o.own) ** 2 for o in seen]
    return float(np.sqrt(sum(squares) / max(1, sum(int(o.keep.sum()) for o in seen))))


def weighted_floor(replays: Sequence[Replay]) -> float:
    """The same in standard deviations over all channels: what a perfect model would score.

    NaN where nothing is repeated.
    """
    parts = []
    for a, b in replicate_pairs(replays):
        for channel, seen in a.observed.items():
            other = b.observed[channel]
            error = (seen.values - other.values)[seen.keep & other.keep]
            parts.append(np.clip(error / (np.sqrt(2) * seen.sd), -CLIP, CLIP) * seen.weight)
    return float(np.sqrt(np.mean(np.concatenate(parts) ** 2))) if parts else float("nan")
