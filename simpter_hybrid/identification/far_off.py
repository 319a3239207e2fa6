"""A declared number that is farther off than its tolerance lets a refit go: no effect is that."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from ..checks.validation import validate
from ..problems import InvalidInput
from ..scenario import Scenario
from .doubted_channels import HALF
from .fitting.farther import best_along, halved_along
from .fitting.fit import WIDE, Fitter
from .fitting.fitted_model import Model, Split
from .fitting.predictor import Parameter
from .fitting.replay import Replay
from .fitting.residual import errors_by_experiment, rms
from .numbers_instead import HALVED, OFF, moved_numbers, number_instead
from .rigs.effect_candidate import EffectCandidate
from .tracing.limits import IMPERFECT
from .tracing.rivals import FAR_WORSE
from .tracing.rounds import SearchResult
from .unexplained import FAR

#: How many times as large or small as declared a number may be; a step of its fit.
TIMES, STEP = 20.0, 0.02
#: Factors that are tried before a fit: with twice its friction
#: a model rests where the device moves, and no small step changes that.
TRIED = (0.07, 0.25, 0.4, 0.63, 1.6, 2.5, 4.0, 15.0)
#: Factors of other prefixes, tried where those leave over `HALF`: g for kg, cm for m.
PREFIXES = (1e-3, 1e-2, 1e2, 1e3)
#: A refitted model that leaves so many deviations of the noise is asked before a search whether a
#: prefix is wrong, and told if so small a part of that is left.
ASTRAY, PLAINLY = 10.0, 0.25
#: Most others that are told beside the one with which least is left: of a motor's resistance that
#: was declared a tenth of the true one ten times the inertia did nearly all as well.
OTHERS = 2
#: Numbers, by part and field, of what pulls where an axis rests as well: forces go with each.
PULLS = {
    "device.weight", "SpringForce.stiffness", "SpringForce.stiffening", "EndSpring.stiffness",
    "Imbalance.cosine", "Imbalance.sine", "RippleForce.cosine", "RippleForce.sine",
    "TabulatedForce.weight", "BiasForce.bias", "BiasDrift.bias", "BiasDrift.rate",
}  # fmt: skip
#: ... and of friction and drag.
FORCES = PULLS | {
    "torque.coulomb", "torque.viscous", "DryDrag.level", "ViscousDrag.coefficient",
    "QuadraticDrag.coefficient", "PowerLawDrag.level", "EddyDrag.peak",
}  # fmt: skip
#: ... and of loads that pull, and whose other numbers stay.
PULLING = {
    "PulledSpring.stiffness", "ReplayedPull.stiffness", "MovingHand.stiffness",
    "RampOnCoordinate.base",
}  # fmt: skip


class FarOff(NamedTuple):
    """A declared number with which the model errs far less than within its tolerance.

    Parameters
    ----------
    name : str
    times : float
        Its value over what is declared; all others are refitted within their tolerances.
    left : float
        Part of the refitted model's error on the selecting runs that is left with it.
    others : tuple of FarOff
        Other numbers with which, one at a time, no more than `FAR_WORSE` times that is left.
    known : bool
        Whether a tolerance of it is declared.
    """

    name: str
    times: float
    left: float
    others: tuple[FarOff, ...] = ()
    known: bool = True


def first_far_off(
    predictor: Any, parts: Mapping[str, list[Replay]], refitted: Mapping[str, float]
) -> FarOff | None:
    """The declared number with another prefix with which far less is left of the fitted runs.

    Asked before a search, of a refitted model that is far from them: a search takes a minute, and
    whoever ends it should know.
    """
    runs = parts["fit"]
    noise = rms(np.array([seen.own for run in runs for seen in run.observed.values()]))
    error, _ = errors_by_experiment(predictor, refitted, runs)
    if error < ASTRAY * noise:
        return None
    found = []
    for p in (q for q in predictor.parameters if np.isfinite(q.tolerance)):
        fitter = _fitter(predictor, runs, 1.0, p, p.value)
        starts = refitted, {q.name: q.value for q in fitter.predictor.parameters}
        ended = (best_along(fitter, x, fitter.residuals(x), [p], _times(PREFIXES)) for x in starts)
        found.append((p, *min(ended, key=lambda one: _cost(one[1]))))
    if not found:
        return None
    p, begun, at = min(found, key=lambda one: _cost(one[2]))
    fitted = _fitter(predictor, runs, 1.0, p, begun[p.name]).fit(begun, iterations=4, at=at).values
    left = errors_by_experiment(predictor, fitted, runs)[0] / error
    off = FarOff(p.name, fitted[p.name] / p.value, left)
    return off if left <= PLAINLY and max(off.times, 1.0 / off.times) > 1.0 / HALF else None


def far_off(done: SearchResult, split: Split, least: float) -> FarOff | None:
    """The declared number without whose tolerance far less is left, if there is one.

    Less than half of the refitted model's error, and about as little as with all effects that were
    found.  Asked one number at a time, for a gain of all of them shows in no motion; only where the
    refitted model leaves more than the error `least`, and no effect explains that plainly, with
    all numbers within their limits.  A mass or an inertia of one axis is asked without a tolerance,
    too.
    """
    model = done.refitted
    declared = [p for p in model.predictor.parameters if np.isfinite(p.tolerance)]
    plain = done.verdict.kind == "effect" and not _any_at_limit(done.corrected, declared)
    if plain or model.select_error <= least:
        return None
    asked = [_without_tolerance(model, p, split) for p in declared]
    asked += [_untold(model, name, split) for name in _moved_untold(model.predictor)]
    ranked = sorted((one for one in asked if one is not None), key=lambda o: o.left)
    most = min(HALF, IMPERFECT * done.corrected.select_error / model.select_error)
    if not ranked or ranked[0].left >= most:
        return None
    found, *others = ranked
    near = [o for o in others if o.left < min(HALF, FAR_WORSE * found.left)]
    return found._replace(others=tuple(near[:OTHERS]))


def by_its_inverse(off: FarOff, declared: Scenario) -> str:
    """What does the same of an axis that nothing drives, in words; "" if nothing else does.

    Its motion tells ratios of forces to its inertia alone: a weight too small looks like an inertia
    too large.  An inertia with a rotor's beside it that stays is only part of that, and so is a
    force beside a weight or a spring, or all else that pulls, if that stays.
    """
    groups = {t["name"]: t["parameters"] for t in declared.notes.get("tolerances", ())}
    numbers = groups.get(off.name, ()) if off.known else (off.name,)
    if not numbers:
        return ""
    if {*numbers} == moved_numbers(declared).keys():
        return f"all its forces {1.0 / off.times:.3g} times as declared"
    values = zip(declared.parameter_names(), declared.parameter_values(), strict=True)
    kinds = {name: _kind(declared, name) for name, value in values if value}
    pulls = {name for name, kind in kinds.items() if kind in PULLS | PULLING}
    # Of a friction beside a weight it is not so, nor of a gear or a time.
    if pulls <= {*numbers} and all(kinds.get(n) in FORCES for n in numbers):
        return f"an inertia {1.0 / off.times:.3g} times as declared"
    return ""


def _kind(declared: Scenario, name: str) -> str:
    """Part and field of a number: "SpringForce.stiffness" of ``effect.1.SpringForce.stiffness``."""
    *_, part, field = name.split(".")
    if name.startswith("load."):
        part = type(declared.loads[int(name.split(".")[1]) - 1]).__name__
    return f"{part}.{field}"


def _moved_untold(predictor: Any) -> tuple[str, ...]:
    """Masses and inertias of one axis of which no tolerance is declared."""
    declared: Scenario = predictor.declared
    told = {n for t in declared.notes.get("tolerances", ()) for n in t["parameters"]}
    if declared.device.n != 1:  # of several a robot's candidates ask
        return ()
    return tuple(
        n for n in moved_numbers(declared) if n not in told and n in predictor.runner.names
    )


def _untold(model: Model, name: str, split: Split) -> FarOff | None:
    """What is left with a number free that has no tolerance; None if it stays near."""
    found = number_instead(model.predictor, name, model.values, split.fit, split.select)
    near = max(found.times, 1.0 / found.times) <= OFF
    return None if near else FarOff(name, found.times, found.left, known=False)


def _any_at_limit(model: Model, declared: Sequence[Parameter]) -> bool:
    """Whether a declared number was refitted as far as it may be: another may be off."""
    inside = ((p, 1e-3 * (p.upper - p.lower)) for p in declared)
    return any(
        not p.lower + near < model.values[p.name] < p.upper - near
        for p, near in inside
        if p.name in model.values
    )


def _without_tolerance(model: Model, p: Parameter, split: Split) -> FarOff | None:
    """What is left with one number free; None if it stays near, or is none that could be."""
    predictor: Any = model.predictor
    fitter = _fitter(predictor, split.fit, model.unit, p, p.value)
    begun, at = min(_begun(fitter, model, p), key=lambda one: _cost(one[1]))
    if not HALF < begun[p.name] / p.value < 1.0 / HALF:  # steps of a fit go with its size
        fitter = _fitter(predictor, split.fit, model.unit, p, begun[p.name])
    values = fitter.fit(begun, iterations=8, at=at).values
    times = values[p.name] / p.value
    # A thousandth is off by no more than a whole, which is two wide tolerances.
    if max(times, 1.0 / times) <= 1.0 + FAR * p.tolerance / p.value:
        return None
    try:
        validate(predictor.scenario(values))
    except InvalidInput:
        return None
    error, _ = errors_by_experiment(fitter.predictor, values, split.select)
    return FarOff(p.name, times, error / model.select_error)


def _fitter(
    predictor: Any, runs: Sequence[Replay], unit: float, p: Parameter, about: float
) -> Fitter:
    """A fitter with one number free, with steps for `about` so large a value."""
    free = EffectCandidate(
        p.name, (_freed(p, about),), ((p.value,),), "declared numbers", "load", ()
    )  # fmt: skip
    return Fitter(predictor.extended(free), runs, step=WIDE, unit=unit)


def _begun(fitter: Fitter, model: Model, p: Parameter):
    """The best of other values, all else as refitted or as declared, with its residuals.

    Far off a residual counts up to a limit alone, so that the way there tells nothing.

    Where one number is far off a refit may have driven all others to their limits.
    """
    for values in (model.values, {q.name: q.value for q in fitter.predictor.parameters}):
        at = fitter.residuals(values)
        found = best_along(fitter, values, at, [p], _times(TRIED))
        if _cost(found[1]) > HALF**2 * _cost(at):
            found = best_along(fitter, *found, [p], _times(PREFIXES))
        if _cost(found[1]) > HALF**2 * _cost(at):
            found = halved_along(fitter, *found, p, (*TRIED, *PREFIXES), HALVED)
        yield found


def _cost(residuals: np.ndarray) -> float:
    return float(residuals @ residuals)


def _times(factors: Sequence[float]) -> Callable[[Parameter, float], list[float]]:
    return lambda p, value: [factor * p.value for factor in factors]


def _freed(p: Parameter, about: float) -> Parameter:
    """A declared number without its tolerance; wide steps lead where narrow ones stick."""
    lower = min(p.lower, p.value / TIMES, about / TIMES)
    upper = max(p.upper, p.value * TIMES, about * TIMES)
    typical = max(p.typical, STEP * p.value) if about == p.value else STEP * about
    return replace(p, lower=lower, upper=upper, typical=typical, tolerance=np.inf)
