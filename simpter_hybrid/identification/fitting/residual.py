"""Weighted residuals of replays: one vector for a fit, one error per channel for a reader."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from .predictor import UNTOLD, Predictor
from .replay import Observation, Replay

#: A residual beyond this many standard deviations counts as that many: an instant that is a sample
#: early makes an error as large as the torque, and says no more than that.
CLIP = 12.0
#: A line may be steeper by so many times what the model moves a row: of one that goes a quarter as
#: fast as the record, which leaves half as much, it is all its start's.
MOVES = 2.0
#: Weight of a breakaway level: one event stands for the ten or so samples that show it.
BREAKAWAY_WEIGHT = 3.0


def weighted_residuals(
    predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
) -> np.ndarray:
    """All residuals, measured minus predicted, in standard deviations, clipped (N,)."""
    predicted = predictor.predict(values, replays)
    return np.concatenate([p for _, _, p in residual_parts(predicted, replays)])


def errors_by_experiment(
    predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
) -> tuple[float, dict[str, float]]:
    """Root mean square over all runs, and over those of each experiment."""
    return predicted_errors(predictor.predict(values, replays), replays)


def predicted_errors(
    predicted: Mapping[str, Sequence[np.ndarray]], replays: Sequence[Replay]
) -> tuple[float, dict[str, float]]:
    """Root mean square over all runs, and of each experiment, of what a prediction tells.

    In standard deviations; samples for which it tells nothing are left out (see
    `compared_only_where_predicted`).
    """
    replays = compared_only_where_predicted(predicted, replays)
    apart: dict[str, list[np.ndarray]] = {}
    for _, i, part in residual_parts(predicted, replays):
        apart.setdefault(replays[i].experiment, []).append(part)
    joined = {name: np.concatenate(parts) for name, parts in apart.items()}
    whole = rms(np.concatenate(list(joined.values()))) if joined else 0.0
    return whole, {name: rms(residuals) for name, residuals in joined.items()}


def compared_only_where_predicted(
    predicted: Mapping[str, Sequence[np.ndarray]], replays: Sequence[Replay]
) -> Sequence[Replay]:
    """Replays with the samples masked for which the model makes no prediction.

    They are not compared, and not counted either, so that abstaining is not rewarded.
    """
    untold = predicted.get(UNTOLD, ())
    if not any(u.any() for u in untold):
        return replays
    found = []
    for replay, unknown in zip(replays, untold, strict=True):
        told = np.asarray(unknown) == 0.0
        seen = {c: replace(o, keep=o.keep & told) for c, o in replay.observed.items()}
        found.append(replace(replay, observed=seen))
    return found


def residual_parts(
    predicted: Mapping[str, Sequence[np.ndarray]], replays: Sequence[Replay]
) -> list[tuple[str, int, np.ndarray]]:
    """(channel, index of the replay, weighted residuals) for everything that is compared.

    Where a model makes no prediction residuals are 0, and those of the run's other samples are
    larger for it: the sum of squares is as if all samples erred like these.
    """
    parts, untold = [], predicted.get(UNTOLD, ())
    for i, replay in enumerate(replays):
        root = np.sqrt(replay.replicates)
        for channel, seen in replay.observed.items():
            error = deviation(seen, predicted[channel][i])
            scaled = _bounded(error * (root / seen.sd), CLIP * root)
            if len(untold):
                scaled = _outweighed(scaled, np.asarray(untold[i])[seen.keep], CLIP * root)
            parts.append((channel, i, scaled * seen.weight))
        if replay.breakaways:
            holds = predicted["breakaway_torque"][i]
            levels = [(abs(b.level) - holds[max(b.index - 1, 0)]) / b.sd for b in replay.breakaways]
            scaled = _bounded(np.array(levels), CLIP)
            parts.append(("breakaway", i, scaled * BREAKAWAY_WEIGHT))
    return parts


def _outweighed(residuals: np.ndarray, untold: np.ndarray, limit: float) -> np.ndarray:
    """Residuals enlarged so that what is `untold` (parts of samples, 0 to 1) is no merit.

    A fit minimises them: to scale keeps zero mean and differences smooth, as a constant in the
    places of what is untold would not.  Of what is told nowhere all count as the worst.
    """
    if not untold.any():
        return residuals
    told = 1.0 - untold
    weight = float(told @ told)
    return residuals * math.sqrt(told.size / weight) if weight else np.full(told.size, limit)


def places(replays: Sequence[Replay]) -> np.ndarray:
    """Run and row of every residual (N, 2): what falls together errs together."""
    found = []
    for i, replay in enumerate(replays):
        rows = [np.flatnonzero(seen.keep) for seen in replay.observed.values()]
        rows.append(np.array([b.index for b in replay.breakaways], dtype=int))
        found += [np.column_stack([np.full(r.size, i), r]) for r in rows]
    return np.concatenate(found)


def channel_errors(
    predicted: Mapping[str, Sequence[np.ndarray]], replays: Sequence[Replay]
) -> dict[str, float]:
    """Root mean square error per channel [SI] over the samples compared; ``breakaway`` relative."""
    replays = compared_only_where_predicted(predicted, replays)
    square: dict[str, float] = {}
    count: dict[str, int] = {}
    for i, replay in enumerate(replays):
        for channel, seen in replay.observed.items():
            error = deviation(seen, predicted[channel][i], weighed=False)
            square[channel] = square.get(channel, 0.0) + float(error @ error)
            count[channel] = count.get(channel, 0) + error.size
        for event in replay.breakaways:
            holds = predicted["breakaway_torque"][i][max(event.index - 1, 0)]
            square["breakaway"] = square.get("breakaway", 0.0) + (holds / abs(event.level) - 1) ** 2
            count["breakaway"] = count.get("breakaway", 0) + 1
    return {c: float(np.sqrt(square[c] / count[c])) for c in square if count[c]}


def errors_by_run(
    predicted: Mapping[str, Sequence[np.ndarray]], replays: Sequence[Replay]
) -> np.ndarray:
    """Root mean square of each run (runs,), in standard deviations; 0 if nothing is compared.

    Samples for which nothing is predicted are left out.
    """
    replays = compared_only_where_predicted(predicted, replays)
    parts: list[list[np.ndarray]] = [[] for _ in replays]
    for _, i, part in residual_parts(predicted, replays):
        parts[i].append(part)
    return np.array([rms(np.concatenate([np.zeros(0), *part])) for part in parts])


def over_rest(predicted: Mapping[str, Sequence[np.ndarray]], replays: Sequence[Replay]) -> float:
    """Error of a prediction over that of no motion at all, for the channel predicted best.

    No motion: every window keeps its first value.  Runs may observe different channels; of one for
    which nothing is predicted the error is infinite.
    """
    calm = [_any_line(replace(replay, breakaways=())) for replay in replays]
    kept = [{c: _kept(seen) for c, seen in replay.observed.items()} for replay in calm]
    channels = dict.fromkeys(c for one in kept for c in one)
    rest = {c: [one.get(c, np.zeros(0)) for one in kept] for c in channels}
    over, alike = channel_errors(predicted, calm), channel_errors(rest, calm)
    return min((over.get(c, math.inf) / alike[c] for c in alike if alike[c] > 0.0), default=0.0)


def _any_line(replay: Replay) -> Replay:
    """Replay without limits on the line removed per window.

    What rests and what moves are so measured alike.
    """
    observed = {c: replace(seen, slopes=()) for c, seen in replay.observed.items()}
    return replace(replay, observed=observed)


def _kept(seen: Observation) -> np.ndarray:
    """What no motion at all would give: the first value of every window throughout (samples,)."""
    starts = np.array(seen.windows or (0,))
    rows = np.searchsorted(starts, np.arange(seen.values.size), side="right") - 1
    return seen.values[starts[rows]]


def deviation(seen: Observation, predicted: np.ndarray, weighed: bool = True) -> np.ndarray:
    """Measured minus predicted where it is compared, less the lines that window starts leave.

    If `weighed`, along the curves that noisy inputs make it counts for less.
    """
    error = seen.values - predicted
    if seen.windows:
        ends = (*seen.windows[1:], error.size)
        apart = [error[a:b] for a, b in zip(seen.windows, ends, strict=True)]
        blocks = [
            without_line(e, _steepest(seen, k, predicted)) if seen.lines else e
            for k, e in enumerate(apart)
        ]
        for block, (shape, part) in zip(blocks, seen.curves if weighed else (), strict=False):
            block -= shape @ (part * (shape.T @ block))
        error = np.concatenate(blocks)
    return error[seen.keep]


def _steepest(seen: Observation, k: int, predicted: np.ndarray) -> float:
    """Largest slope that is taken away from a window as its start's error [SI/sample].

    It is the larger the farther the model moves in the window; infinite without limits.
    """
    if not seen.slopes:
        return math.inf
    a, b = seen.windows[k], (*seen.windows, predicted.size)[k + 1]
    reach = float(np.ptp(predicted[a:b])) / (b - a)
    return seen.slopes[k] + MOVES * reach if np.isfinite(reach) else math.inf


def without_line(values: np.ndarray, most: float = math.inf) -> np.ndarray:
    """Values less their straight line, of which at most the slope `most` [a row] is taken away."""
    if values.size < 3:
        return np.zeros(values.size)
    index = np.arange(values.size) - 0.5 * (values.size - 1)
    centred = values - values.mean()
    slope = float(index @ centred) / float(index @ index)
    return centred - index * min(max(slope, -most), most)


def rms(residuals: np.ndarray) -> float:
    """Root mean square; 1 is the noise, where its standard deviation is right."""
    return float(np.sqrt(np.mean(residuals**2))) if residuals.size else 0.0


def _bounded(error: np.ndarray, limit: float) -> np.ndarray:
    """Clipped; what could not be predicted (NaN) counts as the worst."""
    return np.clip(np.where(np.isfinite(error), error, limit), -limit, limit)
