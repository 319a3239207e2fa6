"""Values of a declared parameter in each run: fitted to half its windows, tested on the other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from .fitting.fitted_model import Model, share
from .fitting.predictor import Parameter
from .fitting.repeats import left_of, window_starts_of
from .fitting.replay import Replay
from .fitting.residual import CLIP, rms
from .run_levels import RunLevels, at_bound, likeliest, reach
from .tracing.rivals import LEAST_GAIN

#: Steps of each run's fit; a step of differences in typical sizes of the parameter.
STEPS, WIDE = 3, 2.0
#: So many changes that matter are as a tolerance where there is none.
UNTOLD = 4.0


def run_levels(
    model: Model,
    replays: Sequence[Replay],
    floor: float,
    names: Sequence[str] = (),
    near: RunLevels | None = None,
) -> RunLevels | None:
    """The declared parameter whose own values explain most; None where none is declared.

    Of those that do as well it is the `likeliest`.

    Parameters
    ----------
    model : Model
    replays : sequence of Replay
        Two or more.
    floor : float
        Error of a perfect model, in standard deviations.
    names : sequence of str
        Parameters that are asked about (all declared ones, if none is given).
    near : RunLevels, optional
        Values of the one parameter asked about, from which those of each run are begun.
    """
    every = model.predictor.parameters
    held = [p for p in every if (p.name in names if names else np.isfinite(p.tolerance))]
    if len(replays) < 2 or not held:
        return None
    return likeliest([_own_values(model, p, replays, floor, near) for p in held])


def _own_values(
    model: Model,
    parameter: Parameter,
    replays: Sequence[Replay],
    floor: float,
    near: RunLevels | None = None,
) -> RunLevels:
    levels, before, after, ended = [], [], [], []
    begun = {} if near is None else near.values(parameter)
    for replay in replays:
        common = _left(model, {}, replay)
        first = begun.get(replay.name, model.values[parameter.name])
        start = _left(model, {parameter.name: first}, replay) if begun else common
        slope = _slope(model, parameter, first, start, replay)
        parts = _halves(replay, slope)
        own = []
        for fitted in (0, 1):
            value = _fitted(model, parameter, replay, parts == fitted, (first, start, slope))
            tested = parts != fitted
            own.append(value)
            before.append(common[tested])
            after.append(_left(model, {parameter.name: value}, replay)[tested])
        levels.append(float(np.mean(own)))
        if any(at_bound(value, parameter) for value in own):
            ended.append(replay.name)
    names, usual = [r.name for r in replays], float(np.median(levels))
    step = parameter.typical if parameter.signed else 0.0
    told = [(x - usual) / step if step else x / usual for x in levels]
    above = 1.0 + (usual - parameter.value) / step if step else usual / parameter.value
    apart = parameter.tolerance if np.isfinite(parameter.tolerance) else UNTOLD * parameter.typical
    first, last = (_error(np.concatenate(parts)) for parts in (before, after))
    # Of what is no more than the floor next to nothing would be all.
    part = share(first, last, floor) if last < (1.0 - LEAST_GAIN) * first else 0.0
    return RunLevels(
        parameter.name, tuple(zip(names, told, strict=True)), first, last, part, _beside(replays),
        above, (max(levels) - min(levels)) / apart, _speeds(replays), step, parameter.unit,
        tuple(ended),
    )  # fmt: skip


def _beside(replays: Sequence[Replay]) -> dict[str, dict[str, float]]:
    """Constants of runs, and means of what was logged, by channel and run."""
    logged = {c: {r.name: float(np.mean(r.logged[c])) for r in replays} for c in replays[0].logged}
    known = [c for c in replays[0].setting if all(c in r.setting for r in replays)]
    return logged | {c: {r.name: r.setting[c] for r in replays} for c in known}


def _speeds(replays: Sequence[Replay]) -> dict[str, float]:
    """Root mean square of the speed of each run that tells one [rad/s or m/s]."""
    return {r.name: rms(np.asarray(r.notes["speed"])) for r in replays if "speed" in r.notes}


def _fitted(
    model: Model,
    p: Parameter,
    replay: Replay,
    rows: np.ndarray,
    begun: tuple[float, np.ndarray, np.ndarray],
) -> float:
    """Gauss-Newton in one parameter on some rows of one run; the best value met.

    `begun`: where, and residuals and slope of all its rows there.
    """
    best, at, slope = begun
    value, least = best, _error(at[rows])
    for k in range(STEPS):
        slope = slope if k == 0 else _slope(model, p, value, at, replay)
        told = rows & np.isfinite(slope) & np.isfinite(at)
        steep = float(slope[told] @ slope[told])
        if steep == 0.0:
            break
        step = float(slope[told] @ at[told]) / steep
        value = float(np.clip(value - step, *reach(p)))
        at = _left(model, {p.name: value}, replay)
        error = _error(at[rows])
        if error < least:
            best, least = value, error
    return best


def _left(model: Model, own: Mapping[str, float], replay: Replay) -> np.ndarray:
    """Weighted residuals of all channels, row by row (channels * samples,)."""
    predicted = model.predictor.predict({**model.values, **own}, [replay])
    left = [left_of(replay, c, predicted[c][0]) for c in replay.observed]
    return np.clip(np.concatenate(left), -CLIP, CLIP)


def _slope(
    model: Model, p: Parameter, value: float, at: np.ndarray, replay: Replay
) -> np.ndarray:  # fmt: skip
    """Derivative of the residuals by a parameter (channels * samples,).

    `at` are the residuals at its `value`.
    """
    h = p.difference(value, WIDE * p.typical, reach(p)[0])
    return (_left(model, {p.name: value + h}, replay) - at) / h


def _halves(replay: Replay, slope: np.ndarray) -> np.ndarray:
    """Half, 0 or 1, of each row of all channels (rows,): both halves tell as much of the parameter.

    A mass shows only in windows in which it is accelerated: the window that tells most is in one
    half, the next two are in the other, and so on.
    """
    which, last = [], 0
    for channel, seen in replay.observed.items():
        starts, rows = np.array(window_starts_of(replay, channel)), np.arange(seen.values.size)
        which.append(last + np.searchsorted(starts, rows, side="right") - 1)
        last += starts.size
    window = np.concatenate(which)
    power = np.bincount(window, np.where(np.isfinite(slope), slope, 0.0) ** 2, last)
    half = np.empty(last, int)
    half[np.argsort(-power, kind="stable")] = np.resize((0, 1, 1, 0), last)
    return half[window]


def _error(left: np.ndarray) -> float:
    """Root mean square of what is compared."""
    return rms(left[np.isfinite(left)])
