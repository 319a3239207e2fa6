"""An empirical term: a fitted curve over the variable on which an unexplained residual depends.

It can be simulated and lowers the error, but it is no law: it says how large a force is and not
why, and nothing beyond the range that was recorded.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..effects.empirical_channel import EmpiricalByChannel
from ..effects.empirical_friction import bump
from ..effects.empirical_history import EmpiricalByReversal
from .empirical_terms import IN_TURN, pieces_of, terms_over
from .fitting.fit import Fitter
from .fitting.fitted_model import (
    ENOUGH,
    FURTHER,
    Model,
    Split,
    Trial,
    fitted_model,
    with_effect,
)
from .fitting.identifiability import estimates
from .fitting.search import try_candidates
from .fitting.survey import Probe, survey
from .rigs.effect_candidate import EffectCandidate
from .tracing.rivals import CLEARLY_WORSE, LEAST_GAIN, RIVAL
from .tracing.trace import Trace
from .tracing.verdict import LEAST_SHARE_IF_MUCH

#: How many ways after a reversal a curve over it is drawn to; three hundredths are left there.
WAYS = 3.5
#: Coordinates that are tried, the strongest first.
TRIED = 4
#: A curve about no level does as well if it leaves no more than so much more.
AS_WELL = 0.01
#: Pieces of a way that are tried beside them, the most promising first.
PIECES = 2


@dataclass(frozen=True)
class Empirical:
    """A curve that was added where no law is known.

    Parameters
    ----------
    coordinate : str
        ``balance:coordinate`` over which it is drawn.
    trial : Trial
        Its fit, with what it gains on the selecting runs.
    model : Model
        The corrected model with it.
    place, value, half_width : ndarray (knots,)
        Knots, fitted values and half-widths of their 95 % intervals [SI]; knots over the way since
        a reversal are those of `EmpiricalByReversal`, from -1 at it to 1 far from it.
    alike : tuple of str
        Of the coordinates that were asked: its own, then those over which a curve does nearly as
        well, or none was tried that might.
    """

    coordinate: str
    trial: Trial
    model: Model
    place: np.ndarray
    value: np.ndarray
    half_width: np.ndarray
    alike: tuple[str, ...] = ()

    def drawn(self, points: int = 241) -> tuple[np.ndarray, np.ndarray]:
        """Places and values of the curve as a simulation follows it, from end to end (points,)."""
        knots, effect = self.value, self.trial.candidate.effect  # type: ignore[attr-defined]
        steps = float(knots.size - 1)
        if isinstance(effect, IN_TURN):  # after the last knot comes the first again
            before, after, steps = knots[-1:], knots[:2], steps + 1.0
        elif isinstance(effect, EmpiricalByChannel):
            before, after = 2.0 * knots[:1] - knots[1:2], 2.0 * knots[-1:] - knots[-2:-1]
        else:
            before, after = knots[1:2], knots[-2:-1]
        every = np.concatenate([before, knots, after])
        where = np.linspace(0.0, steps, points)
        curve = [sum(c * bump(x + 1.0 - k) for k, c in enumerate(every)) for x in where]
        return self.place[0] + (self.place[1] - self.place[0]) * where, np.array(curve)

    def recorded(self, place: np.ndarray) -> np.ndarray:
        """Places among the knots in the coordinate's own unit; far off is `WAYS` ways off."""
        effect = self.trial.candidate.effect  # type: ignore[attr-defined]
        if not isinstance(effect, EmpiricalByReversal):
            return place
        return effect.way * -np.log(np.maximum(0.5 * (1.0 - place), np.exp(-WAYS)))


def empirical_term(
    base: Model,
    coordinates: Sequence[str],
    traces: Mapping[str, Sequence[Trace]],
    split: Split,
    floor: float,
) -> Empirical | None:
    """The curve that lowers the held-out error most; None if none does by what is believed.

    Parameters
    ----------
    base : Model
        What has been found so far.
    coordinates : sequence of str
        ``balance:coordinate`` on which its residual depends, strongest first.
    traces : mapping of str to sequence of Trace
        Of the fitted runs; ranges and sizes are taken from them.
    split : Split
    floor : float
    """
    terms: dict[str, EffectCandidate] = {}
    where: dict[str, str] = {}
    names: dict[str, set[str]] = {}
    for coordinate in coordinates:
        over = terms_over(coordinate, traces)
        names[coordinate] = {term.name for term in over}
        for term in over:
            if term.name not in terms and len(terms) < TRIED:
                terms[term.name], where[term.name] = term, coordinate
    pieces = {p.name: (p, c) for c in coordinates for p in pieces_of(c, traces)}
    where |= {name: coordinate for name, (_, coordinate) in pieces.items()}
    probes = best_probes(base, [piece for piece, _ in pieces.values()], split, PIECES)
    trials = try_candidates(base, list(terms.values()), split, floor)
    trials += try_candidates(base, (), split, floor, probes=probes)
    best = min(trials, key=lambda t: t.select_error, default=None)
    if best is None or best.gain < LEAST_GAIN:
        return None
    own = where[best.candidate.name]
    near = {t.candidate.name for t in trials if as_good(t, best)}
    beside = (c for c, of in names.items() if of & near or (of and not of & {*terms}))
    alike = dict.fromkeys((own, *(where[n] for n in where if n in near), *beside))
    return replace(curve_of(best, own, base, split), alike=tuple(alike))


def settles(term: Empirical, before: float, most: float) -> bool:
    """Whether a curve alone explains a lack: no more than a right form leaves is left.

    Parameters
    ----------
    term : Empirical
    before, most : float
        Error of the selecting runs without it, and what a right form leaves.
    """
    trial = term.trial
    return trial.select_error <= most < before and trial.share >= LEAST_SHARE_IF_MUCH


def as_good(trial: Trial, best: Trial) -> bool:
    """Whether a curve does nearly as well as the best one: these runs tell none from the other."""
    nearly = trial.select_error <= CLEARLY_WORSE * best.select_error
    return nearly and trial.share >= RIVAL * best.share


def best_probes(
    base: Model, terms: Sequence[EffectCandidate], split: Split, most: int
) -> list[Probe]:
    """Probes of the curves that promise most, at most so many."""
    return sorted(survey(base, terms, split.fit), key=lambda probe: -probe.gain)[:most]


def curve_of(best: Trial, coordinate: str, base: Model, split: Split) -> Empirical:
    """A trial of a curve as a term that can be drawn, with the intervals of its knots."""
    model = _at_its_level(with_effect(base, best, split), best, base, split)
    fitter = Fitter(model.predictor, split.fit, unit=model.unit)
    fit = fitter.fit(model.values, iterations=1)
    rows, _ = estimates(model.predictor.parameters, fit, split.fit)
    by_name = {r.name: r for r in rows}
    knots = best.candidate.sizes
    return Empirical(
        coordinate,
        best,
        model,
        _places(best.candidate),  # type: ignore[arg-type]
        np.array([model.values[k] for k in knots]),
        np.array([by_name[k].half_width for k in knots]),
    )


def _at_its_level(model: Model, curve: Trial, base: Model, split: Split) -> Model:
    """The model with declared numbers where they were without the curve, if that does as well.

    A curve's level and a scale of all friction do the same, and no sum of squares holds one of them
    where it was: three waves a turn came with friction 14 % lower and a curve that much higher.
    """
    fitter = Fitter(model.predictor, split.fit, unit=model.unit)
    knots = {k: model.values[k] for k in curve.candidate.sizes}
    level = float(np.mean(list(knots.values())))
    declared = (p.name for p in fitter.declared if p.name in base.values)
    start = {**model.values, **{name: base.values[name] for name in declared}}
    start |= {k: value - level for k, value in knots.items()}
    fit = fitter.fit(start, FURTHER, ENOUGH)
    nearer = abs(np.mean([fit.values[k] for k in knots])) < abs(level)
    if not nearer or fit.cost > (1.0 + AS_WELL) * model.cost:
        return model
    levelled = fitted_model(fitter, fit, split, model.effects)
    as_well = levelled.select_error <= (1.0 + AS_WELL) * model.select_error
    return levelled if as_well else model


def _places(term: EffectCandidate) -> np.ndarray:
    effect = term.effect
    ends, count = (getattr(effect, "low", 0.0), getattr(effect, "high", 1.0)), len(term.sizes)
    turns = isinstance(effect, IN_TURN)
    return np.linspace(*ends, count + 1)[:-1] if turns else np.linspace(*ends, count)
