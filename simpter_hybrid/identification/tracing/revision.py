"""What earlier rounds concluded, asked again with the effects that later rounds have found."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from ..fitting.effort import effort_of
from ..fitting.farther import known_by
from ..fitting.fitted_model import ENOUGH, Model, Split, Trial, largest_fall, refitted
from ..fitting.memory import Memory
from ..fitting.predictor import Candidate
from ..fitting.residual import errors_by_experiment
from .rivals import LEAST_FURTHER, OFF_FLOOR, RICHER_FORM, RIVAL, excluded, shows
from .verdict import Verdict

#: So many other forms of an accepted effect are asked, those with the lowest errors.
FORMS = 3


def without_needless(
    model: Model, declared: Model, split: Split, last: Candidate | None = None
) -> Model:
    """Drop an earlier effect again if the later ones have taken over what it explained.

    It is kept if it still lowers the error as a first effect has to: that of all runs, or of one
    experiment's.  `last` is never dropped: the latest effect, unless another one is given.
    """
    if len(model.effects) < 2:
        return model
    last = model.effects[-1] if last is None else last
    _, apart = errors_by_experiment(model.predictor, model.values, split.select)
    for effect in model.effects:
        if effect is last:
            continue
        rest = tuple(e for e in model.effects if e is not effect)
        smaller = _refitted_with(rest, model, declared, split)
        fall = largest_fall(smaller.by_experiment, apart)
        if not shows(1.0 - model.select_error / smaller.select_error, fall):
            return without_needless(smaller, declared, split, last)
    return model


def begun_anew(
    model: Model, declared: Model, split: Split, floor: float, memory: Memory | None = None
) -> Model:
    """A model with the same effects, fitted once more from each start of each beside the others.

    What was fitted while another was missing may end beside the valley that both have.
    """
    if len(model.effects) < 2 or model.select_error <= OFF_FLOOR * floor:
        return model
    known, best = memory or Memory(), model
    for effect in model.effects:
        names = [p.name for p in effect.parameters]
        for start in effect.starts:
            if effort_of(model.predictor).used_up:
                return best
            values = {**best.values, **dict(zip(names, start, strict=True))}
            begun = replace(best, values=values)
            fitted = partial(_refitted_with, best.effects, begun, declared, split)
            other = known.of(best, ("begun anew", effect.name, start), fitted)
            # Without tolerances, which two fits may have weighed by different units.
            fell = _squares(other) < (1.0 - ENOUGH) * _squares(best)
            if fell and other.select_error < best.select_error:
                best = other
    return best


def _squares(model: Model) -> float:
    return float(model.residuals @ model.residuals)


def with_better_rivals(
    verdicts: Sequence[Verdict],
    model: Model,
    declared: Model,
    split: Split,
    floor: float,
    one_way: bool = False,
    memory: Memory | None = None,
) -> tuple[list[Verdict], Model]:
    """Put a rival in the place of an accepted effect where the whole model is better with it.

    That is so if fewer effects do as well with the rival, or if the errors exclude the accepted
    one.  Two first effects may leave the same as long as others are missing too; then the wrong one
    may have been named because it was better by chance, and a later one has mended what it had
    bent.  A model with one effect more has to lower the error by what is asked of a further effect.
    """
    memory = memory or Memory()
    families = {e.family for e in model.effects}
    for k, verdict in enumerate(verdicts if len(families) > 1 else ()):
        best = verdict.accepted
        if best is None or best.candidate not in model.effects:
            continue
        for rival in verdict.rivals:
            if rival.candidate.family in families:
                continue
            instead = with_rival(rival, best.candidate, model, declared, split, memory)
            if instead is None or excluded(
                model.select_error, instead.select_error, floor, one_way
            ):
                continue
            other = without_needless(instead, declared, split, rival.candidate)
            fewer = len(other.effects) < len(model.effects)
            as_well = 1.0 - model.select_error / other.select_error < LEAST_FURTHER
            if (fewer and as_well) or excluded(
                other.select_error, model.select_error, floor, one_way
            ):
                rest = tuple(r for r in verdict.rivals if r is not rival)
                changed = replace(verdict, accepted=rival, rivals=(best, *rest))
                again = [*verdicts[:k], changed, *verdicts[k + 1 :]]
                return with_better_rivals(again, other, declared, split, floor, one_way, memory)
    return list(verdicts), model


def with_better_forms(
    verdicts: Sequence[Verdict],
    trials: Sequence[Sequence[Trial]],
    model: Model,
    declared: Model,
    split: Split,
    far: bool,
    memory: Memory | None = None,
) -> tuple[list[Verdict], Model]:
    """Put another form of an accepted effect in its place where the whole model is better with it.

    While others were missing, two forms were told apart by what they bent to.  Where the model is
    `far` from what a right form leaves, the error has to fall by what is asked of a further effect.
    What an effect contains takes its place in any case, if that leaves about as little with fewer
    numbers.  `trials`: of each round.
    """
    memory = memory or Memory()
    for k, (verdict, tried) in enumerate(zip(verdicts, trials, strict=True)):
        best = verdict.accepted
        if len(model.effects) < 2 or best is None or best.candidate not in model.effects:
            continue
        for form in _forms(best, tried, far):
            if effort_of(model.predictor).used_up:
                return list(verdicts), model
            other = with_rival(form, best.candidate, model, declared, split, memory)
            if other is None:
                continue
            rise = other.select_error / model.select_error - 1.0
            better = rise <= -LEAST_FURTHER and _squares(other) < _squares(model)
            if better or (_within(form, best) and rise <= RICHER_FORM):
                rest = tuple(r for r in verdict.rivals if r.candidate is not form.candidate)
                changed = replace(verdict, accepted=form, rivals=rest)
                again = [*verdicts[:k], changed, *verdicts[k + 1 :]]
                return with_better_forms(again, trials, other, declared, split, far, memory)
    return list(verdicts), model


def _within(form: Trial, best: Trial) -> bool:
    fewer = len(form.candidate.parameters) < len(best.candidate.parameters)
    return fewer and form.candidate.name in best.candidate.contains


def _forms(best: Trial, tried: Sequence[Trial], far: bool) -> list[Trial]:
    """What an effect contains, and if the model is `far` off the best of its other forms."""
    within = [t for t in tried if _within(t, best)]
    alike = [t for t in tried if t.candidate.family == best.candidate.family and t is not best]
    near = [t for t in alike if t.share >= RIVAL * best.share and t not in within]
    return [*within, *(near[:FORMS] if far else [])]


def asked_again(
    verdict: Verdict,
    model: Model,
    declared: Model,
    split: Split,
    floor: float,
    one_way: bool = False,
    memory: Memory | None = None,
) -> Verdict:
    """The verdict of a round without the rivals that the whole model excludes.

    While another effect is missing as well, errors are far above the floor and say little about
    which of two is the right one.  An effect that was dropped again has no rivals.
    """
    best = verdict.accepted
    if best is not None and best.candidate not in model.effects:
        return replace(verdict, rivals=(), as_well=())
    if best is None or len(model.effects) < 2:
        return verdict
    memory, families, kept = memory or Memory(), {e.family for e in model.effects}, []
    for rival in verdict.rivals:
        if rival.candidate.family not in families:
            instead = with_rival(rival, best.candidate, model, declared, split, memory)
            if instead and excluded(model.select_error, instead.select_error, floor, one_way):
                continue
        kept.append(rival)
    return replace(verdict, rivals=tuple(kept))


def with_rival(
    rival: Trial,
    best: Candidate,
    model: Model,
    declared: Model,
    split: Split,
    memory: Memory | None = None,
) -> Model | None:
    """The model with a rival in the place of an effect, fitted from where its trial ended.

    None if it does not go together with the other effects, and where a search that was ended has
    not fitted it: what no fit has asked excludes nothing.
    """
    effects = [rival.candidate if e is best else e for e in model.effects]
    predictor = declared.predictor
    for other in (e for e in effects if e is not rival.candidate):
        predictor = predictor.extended(other)
    if not predictor.combines(rival.candidate):
        return None
    start = replace(model, values={**model.values, **rival.fit.values})
    asked = "in its place", best.name, *known_by(rival)
    fitted, memory = partial(_refitted_with, effects, start, declared, split), memory or Memory()
    return None if memory.barred(model, asked) else memory.of(model, asked, fitted)


def _refitted_with(
    effects: Sequence[Candidate], model: Model, declared: Model, split: Split
) -> Model:
    """The declared model with these effects, fitted from the values that `model` has."""
    predictor = declared.predictor
    for effect in effects:
        predictor = predictor.extended(effect)
    return refitted(predictor, split, tuple(effects), model.values, model.unit)
