"""Does a declared parameter differ from run to run?  Asked of what no effect explains.

Friction of another day, a load that was changed, a sensor set up anew: in each run the model would
be right with a value of its own.  No effect of a library does that, and a lack that follows the
runs goes along with heat, distance or position by chance.  So each parameter is fitted to one half
of a run's windows and tested on the other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations

import numpy as np
from scipy.stats import kendalltau

from .fitting.fitted_model import Model, share
from .fitting.predictor import Parameter
from .fitting.repeats import left_of, window_starts_of
from .fitting.replay import Replay
from .fitting.residual import CLIP, rms
from .tracing.rivals import LEAST_GAIN
from .tracing.verdict import LEAST_SHARE_IF_MUCH

#: Steps of each run's fit; a step of differences in typical sizes of the parameter.
STEPS, WIDE = 3, 2.0
#: A run's own value is within this factor of the declared one, or within its tolerance.
OTHER = 3.0
#: Values go with an order of the runs if the probability of that by chance is below this (Kendall's
#: rank correlation).
BY_CHANCE = 0.01
ORDER = "order of the runs"
#: Values this near one another (over their mean) count as the same.
ALIKE = 0.01
#: One of at least so many runs is odd if it is so many times as far from the others as these are
#: from one another: of six that differ by chance one in two hundred is.
FEWEST, ODD = 6, 4.0
#: A correlation of this part of the strongest one may be as good: a few runs hardly tell.
NEARLY = 0.8


@dataclass(frozen=True)
class RunLevels:
    """One parameter with a value of its own in each run.

    Parameters
    ----------
    parameter : str
    levels : tuple of (str, float)
        Each run and its value over their mean; the runs as they were recorded (`in_order`), or
        while effects are looked for those that are fitted first.
    before, after : float
        Root mean square on what was not fitted, with the common value and with the own ones, in
        standard deviations.
    share : float
        Part explained of what lies above the floor.
    logged : mapping of str to mapping of str to float
        Constants, and means of channels that the rig does not read, by channel and run.
    mean : float
        Of the values, over what is declared.
    """

    parameter: str
    levels: tuple[tuple[str, float], ...]
    before: float
    after: float
    share: float
    logged: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    mean: float = 1.0

    def in_order(self, runs: Sequence[str]) -> RunLevels:
        """These levels in the order of `runs`, the pieces of each (", part 2") together."""
        place = {name: k for k, name in enumerate(runs)}
        began = {n: place.get(n, place.get(n.rpartition(", part ")[0], -1)) for n, _ in self.levels}
        return replace(self, levels=tuple(sorted(self.levels, key=lambda one: began[one[0]])))


def differs(found: RunLevels) -> bool:
    """Whether own values explain nearly all that is left, and are not the same in every run."""
    return found.share >= LEAST_SHARE_IF_MUCH and not same_in_all(found)


def same_in_all(found: RunLevels) -> bool:
    """Whether the values are the same in every run: what is known holds the common one back."""
    times = [level for _, level in found.levels]
    return max(times) - min(times) <= ALIKE


def odd_run(found: RunLevels) -> str:
    """The one run whose value is far from all others', which are alike; "" if there is none."""
    ordered = sorted(found.levels, key=lambda one: one[1])
    values = [level for _, level in ordered]
    if len(values) < FEWEST:
        return ""
    for k, others in ((0, values[1:]), (-1, values[:-1])):
        gap = min(abs(values[k] - other) for other in others)
        if gap > ODD * (max(others) - min(others)) and gap > ALIKE:
            return ordered[k][0]
    return ""


def together(found: Sequence[RunLevels]) -> bool:
    """Whether the values of all rise and fall together: what a wrong gain does to all of them."""
    if len(found) < 2:
        return False
    ranked = [
        kendalltau([x for _, x in one.levels], [dict(other.levels)[run] for run, _ in one.levels])
        for one, other in combinations(found, 2)
    ]
    return all(rank.statistic > 0.0 and rank.pvalue < BY_CHANCE for rank in ranked)


def goes_with(levels: RunLevels) -> dict[str, float]:
    """Logged channels, and the order of the runs, with which the values rise or fall.

    Six that rise in their order do not by chance (2 of 720).  What warms up in an afternoon goes
    along with its order: what tells nearly as much as the best is told as well.

    Returns
    -------
    dict of str to float
        Channel, or `ORDER`: Kendall's rank correlation; the strongest first.
    """
    times = [level for _, level in levels.levels]
    asked: dict[str, Sequence[float]] = {
        channel: [means[run] for run, _ in levels.levels]
        for channel, means in levels.logged.items()
    }
    asked[ORDER] = range(len(times))
    asked = {name: places for name, places in asked.items() if len(set(places)) > 1}
    found = {}
    for name, places in asked.items():
        ranked = kendalltau(places, times)
        if ranked.pvalue < BY_CHANCE / len(asked):
            found[name] = float(ranked.statistic)
    best = max(map(abs, found.values()), default=0.0)
    order = sorted(found, key=lambda name: -abs(found[name]))
    return {name: found[name] for name in order if abs(found[name]) >= NEARLY * best}


def run_levels(
    model: Model, replays: Sequence[Replay], floor: float, names: Sequence[str] = ()
) -> RunLevels | None:
    """The declared parameter whose own values explain most; None where none is declared.

    Parameters
    ----------
    model : Model
    replays : sequence of Replay
        Two or more.
    floor : float
        Error of a perfect model, in standard deviations.
    names : sequence of str
        Parameters that are asked about (all declared ones, if none is given).
    """
    held = [p for p in model.predictor.parameters if np.isfinite(p.tolerance)]
    held = [p for p in held if not names or p.name in names]
    if len(replays) < 2 or not held:
        return None
    return max((_own_values(model, p, replays, floor) for p in held), key=lambda found: found.share)


def _own_values(
    model: Model, parameter: Parameter, replays: Sequence[Replay], floor: float
) -> RunLevels:
    levels, before, after = [], [], []
    for replay in replays:
        start = _left(model, {}, replay)
        slope = _slope(model, parameter, model.values[parameter.name], start, replay)
        parts = _halves(replay, slope)
        own = []
        for fitted in (0, 1):
            value = _fitted(model, parameter, replay, parts == fitted, start, slope)
            tested = parts != fitted
            own.append(value)
            before.append(start[tested])
            after.append(_left(model, {parameter.name: value}, replay)[tested])
        levels.append(float(np.mean(own)))
    names, mean = [r.name for r in replays], float(np.mean(levels))
    told = tuple((name, level / mean) for name, level in zip(names, levels, strict=True))
    first, last = (_error(np.concatenate(parts)) for parts in (before, after))
    # Of what is no more than the floor next to nothing would be all.
    part = share(first, last, floor) if last < (1.0 - LEAST_GAIN) * first else 0.0
    return RunLevels(
        parameter.name, told, first, last, part, _beside(replays), mean / parameter.value
    )


def _beside(replays: Sequence[Replay]) -> dict[str, dict[str, float]]:
    """Constants of runs, and means of what was logged, by channel and run."""
    logged = {c: {r.name: float(np.mean(r.logged[c])) for r in replays} for c in replays[0].logged}
    known = [c for c in replays[0].setting if all(c in r.setting for r in replays)]
    return logged | {c: {r.name: r.setting[c] for r in replays} for c in known}


def _fitted(
    model: Model, p: Parameter, replay: Replay, rows: np.ndarray, at: np.ndarray, slope: np.ndarray
) -> float:  # fmt: skip
    """Gauss-Newton in one parameter on some rows of one run; the best value met.

    `at` and `slope` are of all its rows, where the model is.
    """
    value = best = model.values[p.name]
    least = _error(at[rows])
    for k in range(STEPS):
        slope = slope if k == 0 else _slope(model, p, value, at, replay)
        told = rows & np.isfinite(slope) & np.isfinite(at)
        steep = float(slope[told] @ slope[told])
        if steep == 0.0:
            break
        step = float(slope[told] @ at[told]) / steep
        value = float(np.clip(value - step, *_reach(p)))
        at = _left(model, {p.name: value}, replay)
        error = _error(at[rows])
        if error < least:
            best, least = value, error
    return best


def _reach(p: Parameter) -> tuple[float, float]:
    """Least and largest own value of a run; a tolerance does not bound it, as for another load."""
    if p.lower <= 0.0:
        return p.lower, p.upper
    return min(p.lower, p.value / OTHER), max(p.upper, p.value * OTHER)


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
    h = WIDE * p.typical if value + WIDE * p.typical <= p.upper else -WIDE * p.typical
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
