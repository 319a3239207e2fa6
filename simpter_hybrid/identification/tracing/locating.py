"""Where a lack is located: which dependences of a residual count."""

from __future__ import annotations

from collections.abc import Sequence

from .named import balance_of
from .ringing import RINGING
from .signature import Dependence
from .slow_state import RUN

#: Where the error is this near the floor no candidate can gain what would be believed.
CLEAN = 1.01
#: A dependence counts if it lowers the held-out mean square by this, at this p-value.
LEAST_DEPENDENCE, P_VALUE = 0.02, 0.01
#: Where something is missing for certain this p-value is enough to say on what it depends.
FAINT = 0.05
#: ... and, where there are few samples, by this many over their number: a curve learned by chance
#: takes away about one for each of its bins.
CHANCE = 6.0
#: A curve in levels of breakaway counts only with this standard deviation: learned from levels
#: that scatter by 1 % and depend on nothing it had up to 0.9 % in eleven recordings.
LEAST_LEVEL = 0.015
#: Balance of the spread from sample to sample.  Wrong instants spread a residual as well, so it is
#: asked only where the error is above the floor and no force, and no level, depends on anything.
VIBRATION = "vibration"
#: A spread scatters by itself (its square is that of noise), so little of it can ever be told.
LEAST_VIBRATION = 0.002
#: A slow state of a run's own took away 0.47 to 0.79 of the square in own recordings; nulls and
#: what depends on a coordinate, nothing.
LEAST_SLOW = 0.1
#: Beside a slow state a coordinate that takes away less than this part of what it does is chance:
#: own hidden states left coordinates 0 to 0.05 of it, what depends on a coordinate 0.66 and more.
BESIDE_SLOW = 0.25
#: A line that stands out after breakaways: 19 to 190 times the spectrum in own recordings that
#: squeal, up to 2 in those that do not; six times is asked, which is this part of its power.
LEAST_RINGING = 1.0 - 1.0 / 6.0
#: Where it rings a coordinate counts only if it takes away this part of the lack.
BESIDE_RINGING = 1.0 / 6.0
#: Kinds of dependence that are asked only where no force and no level depends on a coordinate, in
#: this order, each with the least gain that counts.
LAST = {RINGING: LEAST_RINGING, RUN: LEAST_SLOW, VIBRATION: LEAST_VIBRATION}
#: Those of them whose least gain is large: they count before a faint dependence on a coordinate.
PLAIN = (RINGING, RUN)
#: Coordinates go together (angle and distance): those with this part of the largest gain are one.
ALIKE = 0.6


def located(
    dependences: Sequence[Dependence],
    kind: str = "",
    p_value: float = P_VALUE,
    alike: float = ALIKE,
    least: float = LEAST_DEPENDENCE,
) -> tuple[str, ...]:
    """Coordinates on which residuals depend: each balance's strongest and those that go with it.

    `kind`: one of `LAST` instead.  `alike`: part of the strongest's gain from which on one goes
    with it.  `least`: part of the mean square that one takes away.
    """
    least, chance = LAST.get(kind, least), 0.0 if kind == RINGING else CHANCE
    sure = [
        d
        for d in dependences
        if _kind(d) == kind
        and d.gain >= max(least, chance / d.samples)
        and d.p_value <= p_value
        and (balance_of(d.coordinate) != "breakaway" or d.spread >= LEAST_LEVEL)
    ]
    largest: dict[str, float] = {}
    for d in sure:
        balance = balance_of(d.coordinate)
        largest[balance] = max(largest.get(balance, 0.0), d.gain)
    # Gains of different balances do not compare.
    return tuple(d.coordinate for d in sure if d.gain >= alike * largest[balance_of(d.coordinate)])


def without_coordinate(
    dependences: Sequence[Dependence], kinds: Sequence[str] = tuple(LAST)
) -> tuple[str, ...]:
    """First of `kinds` (ringing, slow state, vibration) that has a sure dependence; () if none."""
    return next((found for kind in kinds if (found := located(dependences, kind))), ())


def or_slow(where: Sequence[str], dependences: Sequence[Dependence]) -> tuple[str, ...]:
    """Coordinates `where`, of which a slow state replaces those of its balance that do far less.

    It stands before those that do less than `ALIKE` of what it does.
    """
    gains = {d.coordinate: d.gain for d in dependences}
    for slow in located(dependences, RUN):
        balance = balance_of(slow)
        own = [c for c in where if balance_of(c) == balance and c != slow]
        part = max((gains.get(c, 0.0) for c in own), default=gains[slow]) / gains[slow]
        if part < BESIDE_SLOW:
            where = (slow, *(c for c in where if c not in own))
        elif part < ALIKE:
            where = (slow, *(c for c in where if c != slow))
    return tuple(where)


def before_ringing(
    where: Sequence[str], dependences: Sequence[Dependence], ratio: float
) -> tuple[str, ...]:
    """Coordinates `where`, or that it rings if it does and they take hardly any of the lack away.

    `ratio`: error over the floor.
    """
    if any(balance_of(c) == "breakaway" for c in where):  # a few levels tell much of themselves
        return tuple(where)
    gains = {d.coordinate: d.gain for d in dependences}
    lack = max(0.0, 1.0 - 1.0 / ratio**2) if ratio > 0.0 else 0.0
    if where and max(gains.get(c, 0.0) for c in where) < BESIDE_RINGING * lack:
        return located(dependences, RINGING) or tuple(where)
    return tuple(where)


def telling(
    dependences: Sequence[Dependence],
    ratio: float,
    least: float = LEAST_DEPENDENCE,
    clean: float = CLEAN,
) -> tuple[str, ...]:
    """Where a lack is located, given the error over the floor.

    At the floor (up to `clean` times it) only levels of breakaway tell, and what rings after it,
    which are too short to raise the error; a balance of forces of which little was recorded may
    depend on this and that while nothing is missing.
    """
    found = located(dependences, least=least)
    if ratio <= clean:
        found = tuple(c for c in found if balance_of(c) == "breakaway")
    return before_ringing(found, dependences, ratio) or located(dependences, RINGING)


def _kind(dependence: Dependence) -> str:
    """Which of `LAST` a dependence is; "" if it is one on a coordinate."""
    return next((part for part in dependence.coordinate.split(":") if part in LAST), "")
