"""Declared numbers, one at a time, with which a model errs as little as with a map put right."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from typing import Any, NamedTuple

from ..scenario import Scenario
from .fitting.farther import best_along, halved_along
from .fitting.fit import WIDE, Fitter
from .fitting.predictor import Parameter
from .fitting.replay import Replay
from .fitting.residual import rms, weighted_residuals
from .rigs.effect_candidate import EffectCandidate

#: Numbers of a load that make a force of what drives; kinds of those of a device that are moved.
DRIVING, MOVED = ("constant", "resistance"), ("mass", "inertia")
#: Factors of such a number that are tried before a fit, and the bounds and the step of that.
TRIED = (1e-3, 0.01, 0.07, 0.25, 0.5, 2.0, 4.0, 15.0, 50.0, 100.0, 1e3, 1e4, 1e5)
LEAST, MOST, STEP = 1e-4, 1e6, 0.02
#: Times that the interval about the best of them is halved before the fit: ten times the true
#: inertia nearly rests, no step of a fit leads from there, and the widest interval (1.8 decades) is
#: then one of a third.
HALVED = 3
#: A number that is off by less is within what tolerances usually are.
OFF = 1.5
#: Iterations of a fit.
ITERATIONS = 6


class NumberInstead(NamedTuple):
    """A declared number with which a model errs far less than within its tolerances.

    Parameters
    ----------
    name : str
        In the model's file (``device.mass``).
    times : float
        Its value over what is declared; what has a tolerance is refitted.
    left : float
        Part of the refitted model's error that is left with it.
    tolerance : str
        Name of the tolerance that it has to itself, by which all else speaks of it; "" of none.
    """

    name: str
    times: float
    left: float
    tolerance: str = ""

    @property
    def said(self) -> str:
        """The number and how far it is off, in words."""
        times = float(f"{self.times:.3g}")
        own = self.tolerance not in ("", self.name)
        called = f"{self.tolerance} ({self.name})" if own else self.name
        return f"{called} {times:,g} times as declared"


def driving_numbers(declared: Scenario) -> dict[str, float]:
    """Numbers by which what drives makes a force, and their values [SI].

    None where it is a force itself, which has the constant 1.
    """
    named = (
        (f"load.{k}.{field}", float(getattr(load, field, 0.0)))
        for k, load in enumerate(declared.loads, 1)
        for field in DRIVING
    )
    numbers = {name: value for name, value in named if value != 0.0}
    return {} if all(value == 1.0 for value in numbers.values()) else numbers


def moved_numbers(declared: Scenario) -> dict[str, float]:
    """Masses and inertias of the device, and their values [SI]."""
    device = declared.device
    named = (
        (f"device.{f.name}", float(getattr(device, f.name)))
        for f in fields(device)
        if f.metadata.get("dimension") in MOVED
    )
    return {name: value for name, value in named if value > 0.0}


def numbers_instead(
    predictor: Any,
    fitted: Mapping[str, float],
    runs: Sequence[Replay],
    replays: Sequence[Replay],
    most: float,
) -> tuple[NumberInstead, ...]:
    """Declared numbers with each of which alone no more than a part of the error is left.

    Whether they have a tolerance or not.  The best first.

    Parameters
    ----------
    predictor : ScenarioPredictor
        The declared model.
    fitted : mapping of str to float
        As refitted within its tolerances.
    runs, replays : sequence of Replay
        By which a number is fitted, and by which it is judged.
    most : float
        Part of the refitted model's error on `replays`.
    """
    found = [
        one
        for name in _asked(predictor)
        if (one := number_instead(predictor, name, fitted, runs, replays)).left <= most
        and max(one.times, 1.0 / one.times) > OFF
    ]
    return tuple(sorted(found, key=lambda one: one.left))


def _asked(predictor: Any) -> Iterator[str]:
    """Numbers that the simulated model has as the declared one does."""
    known = predictor.runner.names
    numbers = moved_numbers(predictor.declared) | driving_numbers(predictor.declared)
    return (name for name in numbers if name in known)


def number_instead(
    predictor: Any,
    name: str,
    fitted: Mapping[str, float],
    runs: Sequence[Replay],
    replays: Sequence[Replay],
) -> NumberInstead:
    """One number, begun from the best of many values; its name, and all else as above."""
    number = f"{name} instead"

    def freed(about: float) -> Fitter:
        share = Parameter(number, 0.0, LEAST - 1.0, MOST, STEP * about)
        shares = ((number, name),)
        candidate = EffectCandidate(
            number, (share,), ((0.0,),), "declared numbers", "load", (), shares=shares
        )
        return Fitter(predictor.extended(candidate), runs, step=WIDE)

    def begun(start: Mapping[str, float]):
        fitter, begin = freed(1.0), {**start, number: 0.0}
        values, at = _best_factor(fitter, begin)
        return freed(1.0 + values[number]).fit(values, iterations=ITERATIONS, at=at)

    # A refit may have driven all other numbers far, in place of this one.
    nominal = {p.name: p.value for p in predictor.parameters}
    values = min(map(begun, (fitted, nominal)), key=lambda fit: fit.cost).values
    error = rms(weighted_residuals(predictor, fitted, replays))
    left = rms(weighted_residuals(freed(1.0).predictor, values, replays)) / error
    alone = (t for t in predictor.declared.notes.get("tolerances", ()) if t["parameters"] == [name])
    own = next((t["name"] for t in alone), "")
    return NumberInstead(name, 1.0 + values[number], left, own)


def _best_factor(fitter: Fitter, begin: Mapping[str, float]) -> tuple[Mapping[str, float], Any]:
    """The best of `TRIED`, then of ever nearer ones between it and its neighbours; residuals.

    The number that is free is the fitter's last, a share.
    """
    free = fitter.parameters[-1]
    begun = best_along(
        fitter, begin, fitter.residuals(begin), [free], lambda p, x: [t - 1.0 for t in TRIED]
    )
    return halved_along(fitter, *begun, free, TRIED, HALVED, about=1.0)
