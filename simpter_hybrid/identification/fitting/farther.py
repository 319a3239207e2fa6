"""Fits that leave more than a right form does: look round for a deeper valley, and go on there.

Where a candidate swings or switches, the error has many valleys side by side (each error of a
stiffness shifts a phase), and a linear step finds the bottom of the one that it began in.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

import numpy as np

from .calm_runs import led_by_calm_runs
from .fit import FINE, Fit, Fitter
from .fitted_model import ENOUGH, FURTHER, Model, Split, Trial, freed, judged
from .memory import Memory
from .predictor import Parameter

#: Where a parameter is looked for: multiples of a scale, steps in typical sizes of any other.
MULTIPLES = (0.5, 0.7, 0.85, 1.2, 1.4, 2.0)
STEPS = (-2.0, -1.0, -0.5, 0.5, 1.0, 2.0)
#: Rounds, each of which must lower the sum of squares by this part to be followed by another.
MOST, LOWERED = 3, 3e-2


def gone_farther(
    base: Model,
    trials: Sequence[Trial],
    near: Sequence[Trial],
    split: Split,
    floor: float,
    progress: Callable[[str, float], None] = lambda name, gain: None,
    memory: Memory | None = None,
) -> list[Trial]:
    """Trials of which those `near` are fitted farther, best on the selecting runs first."""
    known, found = memory or Memory(), {t.candidate.name: t for t in trials}
    for trial in near:
        asked = "farther", *known_by(trial)
        if known.barred(base, asked):
            break
        # With the weight of tolerances with which the trial has ended.
        fitter = Fitter(base.predictor.extended(trial.candidate), split.fit, unit=trial.fit.unit)
        deeper = known.of(base, asked, partial(_deeper, fitter, trial))
        if deeper is not None:
            fitter, deeper = freed(fitter, deeper)
            farther = judged(trial.candidate, fitter, deeper, base, split, floor)
            farther = finished(base, farther, split, floor, known)
            found[trial.candidate.name] = farther
            progress(f"{trial.candidate.name} farther", farther.gain)
    return sorted(found.values(), key=lambda t: t.select_error)


def simpler_from(
    base: Model,
    trials: Sequence[Trial],
    best: Trial,
    split: Split,
    floor: float,
    progress: Callable[[str, float], None] = lambda name, gain: None,
    memory: Memory | None = None,
) -> list[Trial]:
    """Trials of which simpler forms of `best` begin once more where that has ended.

    A form with a number more may find the way round a ridge before which the plain one has stopped,
    and then be named with a number that is not there (a drag of minus 20 N s/m beside a Stribeck
    friction).
    """
    known, found = memory or Memory(), {t.candidate.name: t for t in trials}
    best = found.get(best.candidate.name, best)
    for trial in list(found.values()):
        start = _shared(trial, best)
        if start is None or trial.fit.cost <= (1.0 + LOWERED) * best.fit.cost:
            continue
        asked = "shared", *known_by(trial), *known_by(best)
        if known.barred(base, asked):
            break
        fitter = Fitter(base.predictor.extended(trial.candidate), split.fit, unit=best.fit.unit)
        fit = known.of(base, asked, partial(fitter.fit, start, MOST * FURTHER, ENOUGH))
        fitter, fit = freed(fitter, fit)
        begun = judged(trial.candidate, fitter, fit, base, split, floor)
        again = finished(base, begun, split, floor, known)
        if again.select_error < trial.select_error:
            found[trial.candidate.name] = again
            progress(f"{trial.candidate.name} from {best.candidate.name}", again.gain)
    return sorted(found.values(), key=lambda t: t.select_error)


def finished(
    base: Model, trial: Trial, split: Split, floor: float, memory: Memory | None = None
) -> Trial:
    """The trial fitted on with narrow steps, if it gains by that on fitted and selecting runs.

    Wide steps of a difference lead from far off, and stop short in a bent valley: one of a Stribeck
    friction is as wide as the speed at which it fades, and the fit left four times the floor of
    what another stroke showed.
    """
    fitter = Fitter(
        base.predictor.extended(trial.candidate), split.fit, step=FINE, unit=trial.fit.unit
    )
    known, asked = memory or Memory(), ("finished", *known_by(trial))
    if known.barred(base, asked):
        return trial
    fit = known.of(base, asked, partial(fitter.fit, trial.fit.values, FURTHER, ENOUGH))
    if fit.cost >= (1.0 - ENOUGH) * trial.fit.cost:
        return trial
    again = judged(trial.candidate, fitter, fit, base, split, floor)
    if again.select_error > trial.select_error:
        return trial
    # Columns that further rounds reuse are of usual steps: a narrow one may see nothing of a stair.
    usual = Fitter(fitter.predictor, split.fit, unit=fit.unit)
    return replace(again, fit=replace(fit, jacobian=usual.jacobian(fit.values, fit.residuals)))


def known_by(trial: Trial) -> tuple[str | float, ...]:
    """What tells a trial from others that were begun likewise: one may act at fewer places."""
    own = (p.name for p in trial.candidate.parameters)
    return (trial.candidate.name, *own, trial.fit.cost)


def _shared(trial: Trial, best: Trial) -> dict[str, float] | None:
    """Values of a simpler form as another form of its family has them; None if it has not all."""
    one, other = trial.candidate, best.candidate
    if one.family != other.family or len(one.parameters) >= len(other.parameters):
        return None
    values = {n: v for n, v in best.fit.values.items() if n in trial.fit.values}
    for p in one.parameters:
        if (same := _same_in(p.name.removeprefix(f"{one.name}."), one.name, best)) is None:
            return None
        values[p.name] = min(max(best.fit.values[same], p.lower), p.upper)
    return values


def _same_in(field: str, simpler: str, best: Trial) -> str | None:
    """The parameter of a form that a simpler one's field is; None if it has none, or several.

    A form of several parts whose `simpler` one is asked for is made of it, part 1, and of more.
    """
    names = [q.name for q in best.candidate.parameters]
    alike = [name for name in names if name.endswith(f".{field}")]
    first = f"{best.candidate.name}.1.{field}"
    if best.candidate.simpler == simpler and first in alike:
        return first
    return alike[0] if len(alike) == 1 else None


def _deeper(fitter: Fitter, trial: Trial) -> Fit | None:
    """Look for a lower error along each parameter of the candidate in turn, and fit on from there.

    Where calm runs lead first; repeated while it helps; None if no fit went lower.
    """
    values: Mapping[str, float] = trial.fit.values
    at = fitter.residuals(values)
    cost, found = float(at @ at), None
    for _ in range(MOST):
        before = cost
        led = None if fitter.effort.used_up else led_by_calm_runs(fitter, values, at)
        if led is not None and led.cost < (1.0 - ENOUGH) * before:
            values, at, found = led.values, led.residuals, led
        if not fitter.effort.used_up:
            values, at = best_along(fitter, values, at, trial.candidate.parameters, _round_about)
        fit = fitter.fit(values, FURTHER, ENOUGH, at=at)
        if fit.cost < (1.0 - ENOUGH) * (before if found is None else found.cost):
            found = fit
        if fit.cost > (1.0 - LOWERED) * before:
            break
        values, at, cost = fit.values, fit.residuals, fit.cost
    return found


def best_along(
    fitter: Fitter,
    values: Mapping[str, float],
    at: np.ndarray,
    parameters: Sequence[Parameter],
    places: Callable[[Parameter, float], Sequence[float]],
) -> tuple[Mapping[str, float], np.ndarray]:
    """Least sum of squares along each parameter in turn, and residuals there.

    Parameters
    ----------
    fitter : Fitter
    values : mapping of str to float
        Where to begin.
    at : ndarray (N,)
        Residuals there.
    parameters : sequence of Parameter
    places : callable (parameter, value) -> sequence of float
        What is tried in place of a value.
    """
    cost = float(at @ at)
    for p in parameters:
        for value in places(p, values[p.name]):
            moved = {**values, p.name: value}
            there = fitter.residuals(moved)
            if (new := float(there @ there)) < cost:
                values, at, cost = moved, there, new
    return values, at


def halved_along(
    fitter: Fitter,
    values: Mapping[str, float],
    at: np.ndarray,
    p: Parameter,
    factors: Sequence[float],
    times: int,
    about: float = 0.0,
) -> tuple[Mapping[str, float], np.ndarray]:
    """Least sum of squares at ever nearer factors between the one there and its neighbours.

    Parameters
    ----------
    fitter, values, at
        As in `best_along`.
    p : Parameter
        Its value is a multiple of its declared one, less `about`.
    factors : sequence of float
        Those that have been tried, of the declared value (1 if that is 0).
    times : int
        How often intervals are halved, by the logarithm.
    about : float
        1 of a share, which is 0 where nothing is off.
    """
    unit, known = p.value or 1.0, sorted({1.0, *factors})
    for _ in range(times):
        factor = values[p.name] / unit + about
        k = int(np.argmin(np.abs(np.log(np.divide(known, factor)))))
        between = [math.sqrt(a * b) for a, b in pairwise(known)]
        halves = between[max(k - 1, 0) : k + 1]
        tried = {p.name: [unit * (x - about) for x in halves]}
        values, at = best_along(fitter, values, at, [p], partial(_among, tried))
        known = sorted((*known, *halves))
    return values, at


def _among(tried: Mapping[str, list[float]], p: Parameter, value: float) -> list[float]:
    return tried[p.name]


def _round_about(p: Parameter, value: float) -> list[float]:
    tried = (
        [value * m for m in MULTIPLES] if p.lower > 0.0 else [value + s * p.typical for s in STEPS]
    )
    inside = dict.fromkeys(min(max(x, p.lower), p.upper) for x in tried)
    return [x for x in inside if x != value]
