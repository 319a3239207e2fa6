"""Where a run that nothing drives began, and how fast: what the whole of it shows.

No row is a better witness than the others.  A polynomial through the first ones is off by what it
cannot follow, and with the phase a hundredth off a stiffness, a floor and a verdict are wrong.  So
each run's start is fitted to all its rows by the model that predicts them, and what another
start would do to a prediction is no evidence for or against any other model.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..fitting.replay import Replay
from ..fitting.residual import CLIP, deviation

#: Of a model: values and runs -> channel -> one array for each run.
Predict = Callable[[Mapping[str, float], Sequence[Replay]], Mapping[str, Sequence[np.ndarray]]]
#: Steps of a fit, and parts of one that are tried before it ends.
STEPS, PARTS = 6, (1.0, 0.3, 0.1)
#: Part of a run's way, and of its highest speed, by which its start is moved to see what that does.
MOVED = 1e-3
#: Standard deviation over median distance of normal noise; what could not be predicted at all is so
#: many deviations off, unless others are less.
NORMAL, NEVER = 1.4826, 1e6
#: A fit ends where a step lowers the sum of squares by less than this part.
ENOUGH = 1e-6


def started(
    predict: Predict, values: Mapping[str, float], replays: Sequence[Replay]
) -> list[Replay]:
    """Replays that begin, where that is free, as is best for this model."""
    free = [i for i, r in enumerate(replays) if r.start_free]
    found = list(replays)
    if not free:
        return found
    runs = [replays[i] for i in free]
    # As fits have it, no sample is farther off than so many others.
    left = _left(predict, values, runs, [np.inf] * len(runs))
    far = [CLIP * max(1.0, NORMAL * float(np.median(np.abs(e)))) if e.size else CLIP for e in left]
    left = [np.clip(e, -limit, limit) for e, limit in zip(left, far, strict=True)]
    for _ in range(STEPS):
        slopes = sensitivities(predict, values, runs)
        steps = [_step(run, s, e) for run, s, e in zip(runs, slopes, left, strict=True)]
        runs, left, gained = _bettered(predict, values, runs, steps, left, far)
        if not gained:
            break
    for i, run in zip(free, runs, strict=True):
        found[i] = run
    return found


def sensitivities(
    predict: Predict, values: Mapping[str, float], replays: Sequence[Replay]
) -> list[dict[str, np.ndarray]]:
    """For each run, what its start does to each observed channel (samples, 2) [SI].

    A thousandth of its way farther on, and of its highest speed faster.
    """
    first = predict(values, replays)
    found: list[dict[str, np.ndarray]] = [{} for _ in replays]
    moved = [
        predict(values, [_moved(r, unit * scale_of(r)) for r in replays]) for unit in np.eye(2)
    ]
    for i, replay in enumerate(replays):
        for name in replay.observed:
            apart = [np.nan_to_num(other[name][i] - first[name][i]) for other in moved]
            found[i][name] = np.column_stack(apart)
    return found


def scale_of(replay: Replay) -> np.ndarray:
    """By how much a start is moved (2,) [SI]."""
    way, speed = np.ptp(replay.notes["position"]), np.max(np.abs(replay.notes["speed"]))
    return MOVED * np.array([way, speed])


def _moved(replay: Replay, by: np.ndarray) -> Replay:
    return replace(replay, notes={**replay.notes, "start": replay.notes["start"] + by})


def _left(
    predict: Predict, values: Mapping[str, float], runs: Sequence[Replay], far: Sequence[float]
) -> list[np.ndarray]:
    """Residuals of each run, in deviations, up to its limit."""
    predicted = predict(values, runs)
    found = []
    for i, (run, limit) in enumerate(zip(runs, far, strict=True)):
        errors = np.concatenate([
            deviation(seen, predicted[name][i], weighed=False) / seen.sd
            for name, seen in run.observed.items()
        ])  # fmt: skip
        none = np.where(np.isfinite(errors), errors, min(limit, NEVER))
        found.append(np.clip(none, -limit, limit))
    return found


def _step(run: Replay, slopes: Mapping[str, np.ndarray], left: np.ndarray) -> np.ndarray:
    """Gauss-Newton step of a start (2,) [SI]."""
    columns = [slopes[name][seen.keep] / seen.sd for name, seen in run.observed.items()]
    return np.linalg.lstsq(np.concatenate(columns), left, rcond=1e-8)[0] * scale_of(run)


def _bettered(
    predict: Predict, values: Mapping[str, float], runs: Sequence[Replay],
    steps: Sequence[np.ndarray], left: Sequence[np.ndarray], far: Sequence[float],
) -> tuple[list[Replay], list[np.ndarray], bool]:  # fmt: skip
    """Each run begun where the largest part of its step that helps leads, and what that leaves."""
    found, lower = list(runs), list(left)
    open_ones, gained = list(range(len(runs))), False
    for part in PARTS:
        asked = [_moved(runs[i], part * steps[i]) for i in open_ones]
        if not asked:
            break
        errors = _left(predict, values, asked, [far[i] for i in open_ones])
        for i, run, error in zip(open_ones, asked, errors, strict=True):
            before, after = float(left[i] @ left[i]), float(error @ error)
            if after < before:
                found[i], lower[i] = run, error
                gained |= after < (1.0 - ENOUGH) * before
        open_ones = [i for i in open_ones if found[i] is runs[i]]
    return found, lower, gained
