"""What the searches on the fitted and the selecting runs find, until nothing more is asked."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from .carried_over import Harmful, without_harmful
from .empirical import Empirical
from .late_by_record import named_by_record
from .recordings.recording import Recording
from .run_levels import RunLevels
from .runwise_search import runwise
from .tracing.rounds import SearchResult
from .unexplained import with_curve_over_rest
from .weighted_search import WeightedSearch, WeightedSearchResult


class Sought(NamedTuple):
    """A search, and what is said of it.

    Parameters
    ----------
    found : WeightedSearchResult
        As weighed: runs, floors and limits are of this.
    done : SearchResult
        What was found, without further effects that do harm.
    levels : tuple of RunLevels
        The declared parameters that explain most by differing from run to run.
    harmful : tuple of Harmful
        The further effects that were left out.
    term : Empirical or None
        A curve over what is left.
    """

    found: WeightedSearchResult
    done: SearchResult
    levels: tuple[RunLevels, ...]
    harmful: tuple[Harmful, ...]
    term: Empirical | None


def sought(search: WeightedSearch, recording: Recording) -> Sought:
    """Search by all means: for effects, for what differs from run to run, for a curve."""
    found, levels = runwise(search, search.settled(search.start))
    levels = tuple(one.in_order([r.name for r in recording.runs]) for one in levels)
    asked = found.split.report, found.floors, found.limit, levels
    done = named_by_record(found.search, recording, found.limit)
    done, harmful = without_harmful(done, *asked)
    done, term = with_curve_over_rest(replace(found, search=done), levels, search.say)
    return Sought(found, done, levels, harmful, term)
