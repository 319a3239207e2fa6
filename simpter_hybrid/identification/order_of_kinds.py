"""Do own values go one way through each repetition of the same runs, as what wears does?

Over all runs they jump back where the next repetition begins.  Each kind of run counts once, by its
mean: whatever else makes kinds differ makes it alike in every repetition.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.stats import kendalltau

from .going_with import PERHAPS
from .run_levels import RunLevels

#: Fewest kinds of which an order is worth a word.
FEWEST = 5


class OrderOfKinds(NamedTuple):
    """Kendall's correlation with the order within repetitions, and how often chance does so."""

    tau: float
    chance: float


def order_of_kinds(levels: RunLevels) -> OrderOfKinds | None:
    """How values go with the order of the runs in each of several repetitions; None if they do not.

    Runs are named "repetition, kind"; pieces of one run (", part 2") are no kinds.
    """
    repetitions: dict[str, dict[str, float]] = {}
    for name, level in levels.levels:
        repetition, _, kind = name.partition(", ")
        repetitions.setdefault(repetition, {})[kind] = level
    first, *others = repetitions.values()
    if not others or len(first) < FEWEST or any([*one] != [*first] for one in others):
        return None
    if any(kind.rpartition(", ")[2].startswith("part ") for kind in first):
        return None
    means = [float(np.mean([one[kind] for one in (first, *others)])) for kind in first]
    ranked = kendalltau(range(len(means)), means)
    if not ranked.pvalue < PERHAPS:
        return None
    return OrderOfKinds(float(ranked.statistic), float(ranked.pvalue))
