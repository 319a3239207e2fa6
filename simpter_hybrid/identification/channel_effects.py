"""Effects of a logged channel in place of own values of runs that go with it.

A friction that warms is another in each run: values of its own do what the effect does, and leave
it nothing to explain.  But they say nothing of another run, nor of what changes within one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from .fitting.fitted_model import refitted
from .fitting.memory import Memory
from .fitting.replay import Replay
from .going_with import ORDER, goes_with, split_by
from .rigs.effect_candidate import EffectCandidate
from .run_levels import AS_WELL, RunLevels
from .tracing.round import Given
from .tracing.rounds import gone_on_with
from .weighted_search import WeightedSearch, WeightedSearchResult


def by_channel_instead(
    search: WeightedSearch, found: WeightedSearchResult, own: Sequence[RunLevels]
) -> WeightedSearchResult | None:
    """The search with common values and an effect of a channel that all own values go with.

    Beside the effects that were found with the own values; None if that leaves more than these.
    """
    channels = [{*goes_with(levels), *split_by(levels)} - {ORDER} for levels in own]
    done, effects = found.search, found.search.corrected.effects
    there = {e.family for e in effects}
    followed = set.intersection(*channels) if channels else set()
    tried = [c for c in _following(search.tried, followed) if c.family not in there]
    if not tried:
        return None
    search.say(f"asking whether {' or '.join(c.name for c in tried)} does as well in all runs")
    fit, select = _common(found.split.fit), _common(found.split.select)
    split = replace(found.split, fit=fit, select=select)
    predictor: Any = search.bench.predictor
    declared = refitted(predictor, split, start=search.start)
    for effect in effects:
        predictor = predictor.extended(effect)
    base = refitted(predictor, split, effects, done.corrected.values, declared.unit)
    given = Given(
        split, found.tracer, done.floor, lambda name, gain: None, found.limit, found.floors.fit,
        Memory(),
    )  # fmt: skip
    made = gone_on_with(done, declared, base, tried, given)
    most = AS_WELL * max(done.corrected.select_error, done.floor)
    if made is None or made.corrected.select_error > most:
        return None
    return replace(found, search=made, split=split, fitted=_common(found.fitted))


def _following(candidates: Sequence[EffectCandidate], channels: set[str]) -> list[EffectCandidate]:
    """Candidates with an effect that follows one of these channels."""
    return [c for c in candidates if any(e.follows() in channels for e in c.effects())]


def _common(replays: Sequence[Replay]) -> list[Replay]:
    return [replace(r, own={}) for r in replays]
