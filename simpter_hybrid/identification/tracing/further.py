"""Which candidates a further round may try, and which of its trials help."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..fitting.fitted_model import Model, Trial
from ..fitting.predictor import Candidate
from ..fitting.search import AT_FLOOR, HOPEFUL
from ..fitting.starts import grown
from ..fitting.survey import Probe
from .limits import IMPERFECT, Limits
from .named import balance_of
from .rivals import LEAST_FURTHER

#: A linear step of what takes all of a lack away promises at least this part of it (own pairs).
PROMISED = 0.25


def open_in_next(
    candidates: Sequence[Candidate],
    base: Model,
    coordinates: Sequence[str],
    floor: float,
    limit: Limits,
) -> list[Candidate]:
    """Candidates for the round after one that has left `coordinates`.

    Those to which one of them belongs, if the floor leaves room for what is asked of a further
    effect.  All, where more is left than imperfect forms leave (a dependence may hide behind
    others), or where more than a right form leaves depends on nothing.
    """
    left, room = set(coordinates), 1.0 - floor / base.select_error >= LEAST_FURTHER
    far = base.select_error > IMPERFECT * floor
    short = room and not left and base.select_error > limit.form * floor
    if not room:
        left = {c for c in left if balance_of(c) == "breakaway"}
    families = {c.family for c in base.effects}
    others = [c for c in candidates if c.family not in families and base.predictor.combines(c)]
    return [c for c in others if far or short or left & {*c.coordinates, *c.echoes}]


def promising(
    probes: Sequence[Probe], base: Model, left: Sequence[str], floor: float
) -> list[Probe]:
    """Probes worth a trial where only one that ends at the floor is believed: few promise that."""
    if not _on_nothing(base, left, floor):
        return list(probes)
    lack = 1.0 - (AT_FLOOR * floor / base.select_error) ** 2
    return [p for p in probes if p.gain >= PROMISED * lack]


def helpful(trials: Sequence[Trial], base: Model, left: Sequence[str], floor: float) -> list[Trial]:
    """Trials that lower the error of the fitted runs: others help the selecting runs by chance.

    Where what is left (`left`) depends on nothing and may be due to imperfect forms, many effects
    patch it: there only one that ends at the floor counts.
    """
    found = [t for t in trials if lowers(t, base)]
    if _on_nothing(base, left, floor):
        found = [t for t in found if t.select_error <= AT_FLOOR * floor]
    return found


def lowers(trial: Trial, base: Model) -> bool:
    """Whether a trial lowers the error of the fitted runs."""
    return trial.fit.cost < (1 - 2 * HOPEFUL) * base.cost


def by_chance(trial: Trial, base: Model | None) -> bool:
    """Whether a trial's gain on the selecting runs is not shared by the fitted ones."""
    return base is not None and trial.gain > 0.0 and not lowers(trial, base)


def _on_nothing(base: Model, left: Sequence[str], floor: float) -> bool:
    """Whether effects were found and what they left depends on nothing and may be their forms'."""
    return bool(base.effects) and not left and base.select_error <= IMPERFECT * floor


def further_forms(
    best: Trial, trials: Sequence[Trial], candidates: Sequence[Candidate]
) -> list[Candidate]:
    """Further forms of the best, begun where the simpler one of each has ended."""
    ended = {t.candidate.name: t for t in trials}
    return [
        replace(c, fitted=tuple(grown(c, ended[c.simpler]).items()))
        for c in candidates
        if c.further
        and c.name not in ended
        and c.family == best.candidate.family
        and c.simpler in ended
    ]
