"""Where a run that nothing drives began, and how fast: what the whole of it shows.

No row is a better witness than the others.  A polynomial through the first ones is off by what it
cannot follow, and with the phase a hundredth off a stiffness, a floor and a verdict are wrong.  So
each run's start is fitted to all its rows by the model that predicts them, whenever it does: one
that another model has fitted makes up for what that lacks.  What another start would do to a
prediction is no evidence for or against a model.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..fitting.replay import Replay
from ..fitting.residual import CLIP, deviation

#: Channel -> one array for each run.
Predicted = Mapping[str, Sequence[np.ndarray]]
#: A model as a function: values and runs -> prediction of runs that begin as they say.
Predict = Callable[[Mapping[str, float], Sequence[Replay]], Predicted]
#: Most steps of a fit of a start, and the parts of a step that are tried, the largest first.
STEPS, PARTS = 6, (1.0, 0.3, 0.1)
#: Most steps from a start that a similar model has fitted; after the first step the derivatives by
#: the start are simulated anew if they promise more than this part of the sum of squares.
NEAR, BENT = 2, 1e-3
#: Part of a run's way, and of its highest speed, by which its start is moved to see what that does.
MOVED = 1e-3
#: Standard deviation over median distance of normal noise; what could not be predicted at all is so
#: many deviations off, unless others are less.
NORMAL, NEVER = 1.4826, 1e6
#: A fit ends where a step lowers the sum of squares by less than this part.
ENOUGH = 1e-6


def started(
    simulate: Predict, values: Mapping[str, float], replays: Sequence[Replay]
) -> list[Replay]:
    """Replays whose unknown initial position and speed are those that fit this model best."""
    free = [i for i, r in enumerate(replays) if r.start_free]
    found = list(replays)
    if free:
        runs, _ = _fitted(simulate, values, [replays[i] for i in free], STEPS)
        for i, run in zip(free, runs, strict=True):
            found[i] = run
    return found


def begun_near(
    simulate: Predict, values: Mapping[str, float], replays: Sequence[Replay]
) -> dict[str, list[np.ndarray]]:
    """Predictions of runs that begin as is best for the model, near where they say.

    Near it what another start does is about the same: mostly it is simulated once.
    """
    free = [i for i, r in enumerate(replays) if r.start_free]
    if not free:
        return {name: list(series) for name, series in simulate(values, replays).items()}
    _, of_free = _fitted(simulate, values, [replays[i] for i in free], NEAR, renew=False)
    rest = [i for i, r in enumerate(replays) if not r.start_free]
    others = simulate(values, [replays[i] for i in rest]) if rest else {}
    found: dict[str, list[np.ndarray]] = {}
    for of, series in ((free, of_free), (rest, others)):
        for name, told in series.items():
            places = found.setdefault(name, [np.zeros(0)] * len(replays))
            for i, one in zip(of, told, strict=True):
                places[i] = one
    return found


def _fitted(
    simulate: Predict, values: Mapping[str, float], runs: Sequence[Replay], steps: int,
    renew: bool = True,
) -> tuple[Sequence[Replay], Predicted]:  # fmt: skip
    """Runs begun where is best in at most so many steps, and what is predicted of them.

    No step is simulated of which the linear model promises next to nothing.
    """
    predicted = simulate(values, runs)
    # As fits have it, no sample is farther off than so many others.
    left = _left(predicted, runs, [np.inf] * len(runs))
    far = [CLIP * max(1.0, NORMAL * float(np.median(np.abs(e)))) if e.size else CLIP for e in left]
    left = [np.clip(e, -limit, limit) for e, limit in zip(left, far, strict=True)]
    slopes: list[dict[str, np.ndarray]] = [{} for _ in runs]
    # What one run does depends on no other.
    going = [i for i, run in enumerate(runs) if not all(run.start_told)]
    for _ in range(steps):
        asked = {i: _step(runs[i], slopes[i], left[i]) for i in going if slopes[i]}
        anew = [i for i in going if renew or not slopes[i] or asked[i][1] > BENT]
        known = {name: [series[i] for i in anew] for name, series in predicted.items()}
        found = sensitivities(simulate, values, [runs[i] for i in anew], known) if anew else []
        for i, slope in zip(anew, found, strict=True):
            slopes[i], asked[i] = slope, _step(runs[i], slope, left[i])
        moves = {i: move for i, (move, promised) in asked.items() if promised > ENOUGH}
        if not moves:
            break
        runs, left, predicted, going = _bettered(
            simulate, values, runs, moves, left, predicted, far
        )
    return runs, predicted


def sensitivities(
    simulate: Predict, values: Mapping[str, float], replays: Sequence[Replay],
    predicted: Predicted | None = None,
) -> list[dict[str, np.ndarray]]:  # fmt: skip
    """For each run the change of every observed channel as its start is moved (samples, 2) [SI].

    It is moved by `scale_of`: a thousandth of the run's way, then of its highest speed.
    `predicted`: what is simulated of these runs, if it is known.
    """
    first = simulate(values, replays) if predicted is None else predicted
    found: list[dict[str, np.ndarray]] = [{} for _ in replays]
    moved = [
        simulate(values, [_moved(r, unit * scale_of(r)) for r in replays]) for unit in np.eye(2)
    ]
    for i, replay in enumerate(replays):
        for name in replay.observed:
            apart = [np.nan_to_num(other[name][i] - first[name][i]) for other in moved]
            found[i][name] = np.column_stack(apart)
    return found


def scale_of(replay: Replay) -> np.ndarray:
    """Changes of position and speed by which a start is moved to see what that does (2,) [SI].

    What is told of it stays.
    """
    way, speed = np.ptp(replay.notes["position"]), np.max(np.abs(replay.notes["speed"]))
    return MOVED * np.array([way, speed]) * ~np.array(replay.start_told)


def _moved(replay: Replay, by: np.ndarray) -> Replay:
    return replace(replay, notes={**replay.notes, "start": replay.notes["start"] + by})


def _left(predicted: Predicted, runs: Sequence[Replay], far: Sequence[float]) -> list[np.ndarray]:
    """Residuals of each run, in deviations, up to its limit."""
    found = []
    for i, (run, limit) in enumerate(zip(runs, far, strict=True)):
        errors = np.concatenate([
            deviation(seen, predicted[name][i], weighed=False) / seen.sd
            for name, seen in run.observed.items()
        ])  # fmt: skip
        none = np.where(np.isfinite(errors), errors, min(limit, NEVER))
        found.append(np.clip(none, -limit, limit))
    return found


def _step(
    run: Replay, slopes: Mapping[str, np.ndarray], left: np.ndarray
) -> tuple[np.ndarray, float]:
    """Gauss-Newton step of a start (2,) [SI], and the part of the squares that it promises."""
    columns = [slopes[name][seen.keep] / seen.sd for name, seen in run.observed.items()]
    joined = np.concatenate(columns)
    step = np.linalg.lstsq(joined, left, rcond=1e-8)[0]
    rest, whole = left - joined @ step, float(left @ left)
    promised = 1.0 - float(rest @ rest) / whole if whole else 0.0
    return step * scale_of(run), promised


def _bettered(
    simulate: Predict, values: Mapping[str, float], runs: Sequence[Replay],
    moves: Mapping[int, np.ndarray], left: Sequence[np.ndarray], predicted: Predicted,
    far: Sequence[float],
) -> tuple[list[Replay], list[np.ndarray], Predicted, list[int]]:  # fmt: skip
    """Take for each run the largest part of its step (`PARTS`) that lowers its error.

    Returns the runs, their residuals, the predictions, and the numbers of the runs that gained by
    it.
    """
    found, lower = list(runs), list(left)
    known = {name: list(series) for name, series in predicted.items()}
    open_ones, gained = list(moves), []
    for part in PARTS:
        asked = [_moved(runs[i], part * moves[i]) for i in open_ones]
        if not asked:
            break
        made = simulate(values, asked)
        errors = _left(made, asked, [far[i] for i in open_ones])
        for j, (i, run, error) in enumerate(zip(open_ones, asked, errors, strict=True)):
            before, after = float(left[i] @ left[i]), float(error @ error)
            if after < before:
                found[i], lower[i] = run, error
                for name in known:
                    known[name][i] = made[name][j]
                if after < (1.0 - ENOUGH) * before:
                    gained.append(i)
        open_ones = [i for i in open_ones if found[i] is runs[i]]
    return found, lower, known, sorted(gained)
