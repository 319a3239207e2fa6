"""What one search hands to the next: the model that weighs residuals, and where fits begin."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from .rigs.effect_candidate import EffectCandidate
from .tracing.rounds import SearchResult

#: Where the corrected model leaves less than one part in so many of what the refitted one does,
#: the curves along which noise moves the latter's predictions are not those of the former's ...
FAR = 2.0
#: ... nor where nothing may be named, and the best candidate leaves less than this: by the curves
#: of a model that sticks where the device moves most of a lack may be noise.
FAR_UNNAMED = 1.2


def better_model(
    done: SearchResult, far: float = FAR
) -> tuple[tuple[str, ...], Any, Mapping[str, float]]:
    """Effects, predictor and values of the corrected model, or of the best candidate's if none is.

    The effects are () where the corrected model does not leave far less than the declared one;
    where the best candidate does not either, the declared model is returned.
    """
    if done.corrected.effects:
        better = done.refitted.select_error > far * done.corrected.select_error
        names = tuple(e.name for e in done.corrected.effects) if better else ()
        return names, done.corrected.predictor, done.corrected.values
    best = done.rounds[0].best
    if best is None or done.refitted.select_error <= FAR_UNNAMED * best.select_error:
        return (), done.refitted.predictor, done.refitted.values
    predictor = done.refitted.predictor.extended(best.candidate)
    return (best.candidate.name,), predictor, best.fit.values


def begun(candidates: Sequence[EffectCandidate], done: SearchResult) -> tuple[EffectCandidate, ...]:
    """Candidates with the values at which a search has fitted them.

    Values of the corrected model come first, then those of the earliest round: later rounds had
    other effects in place.  Only values of the candidate and of the declared model are taken over.
    """
    fits = [t for r in done.rounds for t in r.trials]
    known: dict[str, Mapping[str, float]]
    known = {t.candidate.name: t.fit.values for t in reversed(fits)}
    known |= {e.name: done.corrected.values for e in done.corrected.effects}
    declared = {p.name for p in done.refitted.predictor.parameters}

    def begins(candidate: EffectCandidate) -> EffectCandidate:
        # One that was narrowed has nothing at the other places.
        values = {p.name: p.value for p in candidate.parameters} | dict(known[candidate.name])
        own = declared | {p.name for p in candidate.parameters}
        return replace(candidate, fitted=tuple((k, v) for k, v in values.items() if k in own))

    return tuple(begins(c) if c.name in known else c for c in candidates)
