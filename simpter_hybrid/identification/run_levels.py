"""Does a declared parameter differ from run to run?  Asked of what no effect explains.

Friction of another day, a load that was changed, a sensor set up anew: in each run the model would
be right with a value of its own.  No effect of a library does that, and a lack that follows the
runs goes along with heat, distance or position by chance.  So each parameter gets values of its own
(`own_values`); what these say is told here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import NamedTuple

import numpy as np
from scipy.stats import kendalltau

from .fitting.predictor import AT_LIMIT, Parameter
from .recordings.logged import ASKED_OF
from .tracing.rivals import RIVAL
from .tracing.verdict import LEAST_SHARE_IF_MUCH

#: A run's own value is within this factor of the declared one, or as far off as a refit may go; one
#: of either sign so many times as far.
OTHER = 3.0
#: Values go together if the probability of that by chance is below this (Kendall's rank
#: correlation).
BY_CHANCE = 0.01
#: Values this near one another (over their median) count as the same.
ALIKE = 0.01
#: One run is odd if it is so many times as far from the others as these are from one another: the
#: first with `MANY` runs and more (of six that differ by chance one in 300 is), the second
#: with `FEWEST` and more (of four as many).
ODD, ODD_OF_FEW = 4.0, 20.0
MANY, FEWEST = 6, ASKED_OF
#: Values change once if on both sides, of so many runs, they are alike to this part of the step; of
#: fewer runs some do by chance.
SIDE, STEEP, LEAST_STEPPED = 2, 0.2, 5
#: Own values of another parameter that leave up to so many times what the best leave, and explain
#: nearly as much, do as well.
AS_WELL = 1.05


@dataclass(frozen=True)
class RunLevels:
    """One parameter with a value of its own in each run.

    Parameters
    ----------
    parameter : str
    levels : tuple of (str, float)
        Each run and its value over their median, which one odd run does not move, or of a `step`
        how many of these it is above that; the runs as they were recorded (`in_order`), or while
        effects are looked for those that are fitted first.
    before, after : float
        Root mean square on what was not fitted, with the common value and with the own ones, in
        standard deviations.
    share : float
        Part explained of what lies above the floor.
    logged : mapping of str to mapping of str to float
        Constants, and means of channels that the rig does not read, by channel and run.
    usual : float
        Their median, over what is declared; of a `step` 1 and how many it is above that.
    apart : float
        How far the values are apart, in tolerances of the parameter.
    speeds : mapping of str to float
        Root mean square of each run's speed, if that is known.
    step : float
        What is added for each unit of a level, in the parameter's own; 0 of factors.
    unit : str
        The parameter's.
    ended : tuple of str
        Runs whose values ended at a bound of what is tried.
    """

    parameter: str
    levels: tuple[tuple[str, float], ...]
    before: float
    after: float
    share: float
    logged: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    usual: float = 1.0
    apart: float = 0.0
    speeds: Mapping[str, float] = field(default_factory=dict)
    step: float = 0.0
    unit: str = ""
    ended: tuple[str, ...] = ()

    def median(self, parameter: Parameter) -> float:
        """Their median, in the unit of the `parameter`."""
        if self.step:
            return parameter.value + (self.usual - 1.0) * self.step
        return self.usual * parameter.value

    def values(self, parameter: Parameter) -> dict[str, float]:
        """The value of each run, in the unit of the `parameter`, within what one may reach."""
        usual, (least, most) = self.median(parameter), reach(parameter)
        values = {run: usual + x * self.step if self.step else x * usual for run, x in self.levels}
        return {run: float(np.clip(value, least, most)) for run, value in values.items()}

    def own(self) -> list[float]:
        """What each run has of its own (`Replay.own`), in their order."""
        return [level * (self.step or 1.0) for _, level in self.levels]

    def in_order(self, runs: Sequence[str]) -> RunLevels:
        """These levels in the order of `runs`, the pieces of each (", part 2") together."""
        place = {name: k for k, name in enumerate(runs)}
        began = {n: place.get(n, place.get(n.rpartition(", part ")[0], -1)) for n, _ in self.levels}
        return replace(self, levels=tuple(sorted(self.levels, key=lambda one: began[one[0]])))


def likeliest(found: Sequence[RunLevels]) -> RunLevels:
    """The own values that explain most; of those that do as well the fewest tolerances apart.

    Where nothing drives, only friction over mass shows: a mass that is known to 2 % was said to be
    another in each piece of one run, three times as large in one as in another.
    """
    best = max(found, key=lambda one: one.share)
    return min(
        (o for o in found
         if o is best
         or (o.after <= AS_WELL * best.after and o.share >= RIVAL * best.share)),
        key=lambda one: one.apart,
    )  # fmt: skip


def differs(found: RunLevels) -> bool:
    """Whether own values explain nearly all that is left, and are not the same in every run."""
    return found.share >= LEAST_SHARE_IF_MUCH and not same_in_all(found)


def same_in_all(found: RunLevels) -> bool:
    """Whether the values are the same in every run: what is known holds the common one back."""
    times = [level for _, level in found.levels]
    return max(times) - min(times) <= ALIKE


def as_declared(found: RunLevels) -> bool:
    """Whether the values are the declared one in every run: then windows and runs disagree."""
    return same_in_all(found) and abs(found.usual - 1.0) <= ALIKE


def odd_run(found: RunLevels) -> str:
    """The one run whose value is far from all others', which are alike; "" if there is none."""
    ordered = sorted(found.levels, key=lambda one: one[1])
    values = [level for _, level in ordered]
    if len(values) < FEWEST:
        return ""
    times = ODD if len(values) >= MANY else ODD_OF_FEW
    for k, others in ((0, values[1:]), (-1, values[:-1])):
        gap = min(abs(values[k] - other) for other in others)
        if gap > times * (max(others) - min(others)) and gap > ALIKE:
            return ordered[k][0]
    return ""


class Step(NamedTuple):
    """Values that change once in the order of the runs: alike up to one run, and from another on.

    ``between``: the run between these two, in which it changed; "" if there is none.
    """

    until: str
    before: float
    onwards: str
    after: float
    between: str


def step_of(levels: RunLevels) -> Step | None:
    """The one step of the values in the order of the runs, as a knock makes it; None without it."""
    names, values = [run for run, _ in levels.levels], [level for _, level in levels.levels]
    if len(values) < LEAST_STEPPED:
        return None
    for between in (0, 1):
        for k in range(SIDE, len(values) - SIDE - between + 1):
            first, last = values[:k], values[k + between :]
            before, after = float(np.mean(first)), float(np.mean(last))
            gap = abs(after - before)
            alike = max(np.ptp(first), np.ptp(last)) <= STEEP * gap
            low, high = sorted((before, after))
            within = all(low < value < high for value in values[k : k + between])
            if gap > ALIKE and alike and within:
                middle = names[k] if between else ""
                return Step(names[k - 1], before, names[k + between], after, middle)
    return None


def together(found: Sequence[RunLevels]) -> bool:
    """Whether the values of all rise and fall together: what a wrong gain does to all of them."""
    if len(found) < 2:
        return False
    ranked = [
        kendalltau([x for _, x in one.levels], [dict(other.levels)[run] for run, _ in one.levels])
        for one, other in combinations(found, 2)
    ]
    return all(rank.statistic > 0.0 and rank.pvalue < BY_CHANCE for rank in ranked)


def reach(p: Parameter) -> tuple[float, float]:
    """Least and largest own value of a run; a tolerance does not bound it, as for another load."""
    if p.signed:
        room = OTHER * max(p.upper - p.value, p.value - p.lower, abs(p.value))
        return p.value - room, p.value + room
    if p.lower <= 0.0:
        return p.lower, p.upper
    return min(p.lower, p.value / OTHER), max(p.upper, p.value * OTHER)


def at_bound(value: float, p: Parameter) -> bool:
    """Whether a run's own value ended at a bound of what is tried, and so tells nothing."""
    return min(abs(value - end) for end in reach(p)) <= AT_LIMIT * abs(value)
