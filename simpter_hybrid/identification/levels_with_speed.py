"""Own values of runs that go with how fast these move: what anything that depends on speed does."""

from __future__ import annotations

from itertools import combinations
from math import factorial, prod
from typing import NamedTuple

from scipy.stats import kendalltau

from .going_with import NEARLY, PERHAPS
from .run_levels import FEWEST, RunLevels

#: Runs differ in speed if the fastest is so many times as fast as the slowest.
FASTER = 1.1
#: Between the name of a run and the number of a piece of it.
PIECE = ", piece "


class WithSpeed(NamedTuple):
    """Rank correlation of values with how fast runs move, and how often chance does as much.

    `pieces`: it is one among the pieces of each run.
    """

    tau: float
    chance: float
    pieces: bool = False


def goes_with_speed(levels: RunLevels) -> WithSpeed | None:
    """Whether the values go with how fast each run moves; None if they do not, or hardly.

    No proof of a few runs, but what anything that depends on speed would do.
    """
    runs = [run for run, _ in levels.levels]
    if len(runs) < FEWEST or not all(run in levels.speeds for run in runs):
        return None
    speeds, times = [levels.speeds[run] for run in runs], [level for _, level in levels.levels]
    if max(speeds) <= FASTER * min(speeds):
        return None
    ranked = kendalltau(speeds, times)
    tau, chance = float(ranked.statistic), float(ranked.pvalue)
    if abs(tau) > NEARLY - 1e-9 and chance < PERHAPS:
        return WithSpeed(tau, chance)
    return _within_runs(levels)


def _within_runs(levels: RunLevels) -> WithSpeed | None:
    """Whether in every run the values of its pieces go all one way with their speeds.

    Two coast-downs on other roads hide it: between them the road differs, in each the speed.  Runs
    of which one piece alone has a value show nothing of that, and may go the other way together:
    beside them nothing is told.
    """
    cut: dict[str, list[tuple[float, float]]] = {}
    for name, level in levels.levels:
        whole, dash, _ = name.rpartition(PIECE)
        cut.setdefault(whole if dash else name, []).append((levels.speeds[name], level))
    ordered = [sorted(pieces) for pieces in cut.values()]
    if min(map(len, ordered)) < 2:
        return None
    chance = 2.0 / prod(factorial(len(pieces)) for pieces in ordered)
    if chance >= PERHAPS or any(x[-1][0] <= FASTER * x[0][0] for x in ordered):
        return None
    rises = {b[1] > a[1] for pieces in ordered for a, b in combinations(pieces, 2)}
    return WithSpeed(1.0 if rises == {True} else -1.0, chance, True) if len(rises) == 1 else None
