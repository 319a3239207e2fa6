"""What the own values of a parameter in each run go with: a logged channel, or their order."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import count
from math import copysign, factorial, prod

import numpy as np
from scipy.stats import kendalltau

from .run_levels import ALIKE, BY_CHANCE, FEWEST, STEEP, RunLevels

ORDER = "order of the runs"
#: What chance does as seldom, or more seldom, is worth a word.
PERHAPS = 0.1
#: A correlation of this part of the strongest one may be as good: a few runs hardly tell.
NEARLY = 0.8


def goes_with(levels: RunLevels) -> dict[str, float]:
    """Logged channels, and the order of the runs, with which the values rise or fall.

    Six that rise in their order do not by chance (2 of 720).  What warms up in an afternoon goes
    along with its order: what tells nearly as much as the best is told as well.  A channel that
    splits the values (`split_by`) is as strong as any, as seldom as chance splits them so: ranks
    that are tied tell less than the values do.

    Returns
    -------
    dict of str to float
        Channel, or `ORDER`: Kendall's rank correlation; the strongest first.
    """
    times = [level for _, level in levels.levels]
    asked, found = _orders(levels), {}
    split = _splits(levels)
    for name, places in asked.items():
        ranked = kendalltau(places, times)
        if split.get(name, ranked.pvalue) < BY_CHANCE / len(asked):
            tau = float(ranked.statistic)
            found[name] = copysign(1.0, tau) if name in split else tau
    best = max(map(abs, found.values()), default=0.0)
    order = sorted(found, key=lambda name: -abs(found[name]))
    return {name: found[name] for name in order if abs(found[name]) >= NEARLY * best}


def split_by(levels: RunLevels) -> dict[str, float]:
    """Logged channels of few levels that the values follow: alike at each, and others at others.

    Returns
    -------
    dict of str to float
        Channel: how often chance splits the values so by one of the channels that are asked, below
        `PERHAPS`; the most seldom first.
    """
    split = _splits(levels)
    asked = sum(map(_tied, _orders(levels).values()))
    told = {name: asked * chance for name, chance in split.items() if asked * chance < PERHAPS}
    return dict(sorted(told.items(), key=lambda one: one[1]))


def unasked(levels: RunLevels) -> tuple[str, ...]:
    """Logged channels that differ between runs, of which too few are known to ask for them."""
    if len(levels.levels) >= FEWEST:
        return ()
    return tuple(name for name in _orders(levels) if name != ORDER)


def may_go_with(levels: RunLevels) -> dict[str, float]:
    """Logged channels in the order of which all values rise (1) or fall (-1), of too few runs."""
    times = [level for _, level in levels.levels]
    if len(times) < FEWEST or goes_with(levels):
        return {}
    ranked = {
        name: float(kendalltau(places, times).statistic)
        for name, places in _logged(levels).items()
        if not _tied(places)
    }
    return {name: tau for name, tau in ranked.items() if abs(tau) > 1.0 - 1e-9}


def sure_from(levels: RunLevels) -> int:
    """Number of runs that follow one of the logged channels by chance too seldom to doubt it.

    Of a channel that differs in each of them.
    """
    asked = len(_orders(levels))
    return next(n for n in count(FEWEST) if 2.0 / factorial(n) < BY_CHANCE / asked)


def _splits(levels: RunLevels) -> dict[str, float]:
    """Channels of few levels that split the values, and how often one does by chance."""
    times = [level for _, level in levels.levels]
    return {
        name: _by_chance(places)
        for name, places in _logged(levels).items()
        if _tied(places) and _is_split(times, places)
    }


def _is_split(times: Sequence[float], places: Sequence[float]) -> bool:
    """Whether the values at each level of a channel are alike to the gaps between the levels.

    As those are that change once (`STEEP`): among values that are spread evenly none are.
    """
    at = [[t for t, p in zip(times, places, strict=True) if p == level] for level in set(places)]
    gap = min(np.diff(sorted(float(np.mean(one)) for one in at)), default=0.0)
    return gap > ALIKE and max(float(np.ptp(one)) for one in at) <= STEEP * gap


def _by_chance(places: Sequence[float]) -> float:
    """How often runs fall into the groups that the levels make, each order of them as likely.

    Groups of one size stand for one another: of eight runs four and four do in 2 of 70.
    """
    sizes = Counter(places).values()
    alike = prod(factorial(times) for times in Counter(sizes).values())
    return alike * prod(map(factorial, sizes)) / factorial(len(places))


def _tied(places: Sequence[float]) -> bool:
    """Whether a channel has one level in several runs, and differs."""
    return 1 < len(set(places)) < len(places)


def _orders(levels: RunLevels) -> dict[str, Sequence[float]]:
    """Orders that values are asked for: what is the same in all runs is none."""
    orders: dict[str, Sequence[float]] = {**_logged(levels), ORDER: range(len(levels.levels))}
    return {name: places for name, places in orders.items() if len(set(places)) > 1}


def _logged(levels: RunLevels) -> dict[str, list[float]]:
    """Logged channels, run by run."""
    return {
        channel: [means[run] for run, _ in levels.levels]
        for channel, means in levels.logged.items()
    }
