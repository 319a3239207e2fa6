"""A declared parameter that differs from run to run, where no search is made beside it.

Runs of a rotor are repeated and fitted as means of their repetitions; what differs is asked of each
by itself, and only of what no effect explains: heat and wear differ from run to run as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .fitting.effort import effort_of
from .own_refits import Own, refined, runs_of
from .own_values import run_levels
from .run_levels import differs
from .tracing.slow_state import RUN
from .tracing.verdict import LEAST_SHARE, Verdict
from .weighted_search import WeightedSearchResult

#: Coordinate of what is another in each run.
OF_RUNS = f"friction:{RUN}"


def told_alone(
    found: WeightedSearchResult, names: Sequence[str]
) -> tuple[WeightedSearchResult, Own]:
    """The search, with a verdict that names the run if own values explain what is left; and these.

    Parameters
    ----------
    found : WeightedSearchResult
    names : sequence of str
        Declared parameters that are asked about.
    """
    done = found.search
    if done.verdict.kind != "unknown" or done.corrected.effects:
        return found, ()
    each = replace(found, split=replace(found.split, fit=found.fitted))
    first = run_levels(done.refitted, runs_of(each), found.noise, names)
    if first is None or effort_of(done.refitted.predictor).used_up:
        return found, ()
    if first.share < LEAST_SHARE:
        return found, (first,)
    _, own = refined(done.refitted, (first,), each)
    if effort_of(done.refitted.predictor).used_up:
        return found, ()
    if not all(map(differs, own)):
        return found, own
    # On what the rest depends beside such values was not asked.
    told = replace(done, verdict=Verdict("unknown", coordinates=(OF_RUNS,)))
    return replace(found, search=told), own
