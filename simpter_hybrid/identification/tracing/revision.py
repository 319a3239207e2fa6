"""What earlier rounds concluded, asked again with the effects that later rounds have found."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..fitting.fitted_model import Model, Split, largest_fall, refitted
from ..fitting.predictor import Candidate
from ..fitting.residual import errors_by_experiment
from .rivals import excluded, shows
from .verdict import Verdict


def without_needless(model: Model, declared: Model, split: Split) -> Model:
    """Drop an earlier effect again if the later ones have taken over what it explained.

    What it still explains is asked as it was of a first one: of all runs, or of one experiment's.
    """
    if len(model.effects) < 2:
        return model
    _, apart = errors_by_experiment(model.predictor, model.values, split.select)
    for effect in model.effects[:-1]:
        rest = tuple(e for e in model.effects if e is not effect)
        smaller = _refitted_with(rest, model, declared, split)
        if not shows(1.0 - model.select / smaller.select, largest_fall(smaller, apart)):
            return without_needless(smaller, declared, split)
    return model


def asked_again(
    verdict: Verdict,
    model: Model,
    declared: Model,
    split: Split,
    floor: float,
    one_way: bool = False,
) -> Verdict:
    """The verdict of a round without the rivals that the whole model excludes.

    An effect that was dropped again has none.

    While another effect is missing as well, errors are far above the floor and say little about
    which of two is the right one.
    """
    best = verdict.accepted
    if best is not None and best.candidate not in model.effects:
        return replace(verdict, rivals=(), as_well=())
    if best is None or len(model.effects) < 2:
        return verdict
    families, kept = {e.family for e in model.effects}, []
    others = tuple(e for e in model.effects if e is not best.candidate)
    for rival in verdict.rivals:
        if rival.candidate.family not in families:
            start = replace(model, values={**model.values, **rival.fit.values})
            instead = _refitted_with((*others, rival.candidate), start, declared, split)
            if excluded(model.select, instead.select, floor, one_way):
                continue
        kept.append(rival)
    return replace(verdict, rivals=tuple(kept))


def _refitted_with(
    effects: Sequence[Candidate], model: Model, declared: Model, split: Split
) -> Model:
    """The declared model with these effects, fitted from the values that `model` has."""
    predictor = declared.predictor
    for effect in effects:
        predictor = predictor.extended(effect)
    known = {p.name for p in predictor.parameters}
    start = {name: value for name, value in model.values.items() if name in known}
    return refitted(predictor, split, tuple(effects), start, model.unit)
