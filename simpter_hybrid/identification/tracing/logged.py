"""Channels that were logged and that no model reads: a temperature, a second sensor.

What is left is asked whether it depends on them as it is on every coordinate.  They have no say in
whether something is missing, nor in a name: a copy of a used channel would do what that does.  They
only tell on what something unknown depends, and that only where they tell clearly more than the
coordinates that are always asked.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from .locating import BESIDE_SLOW, LAST, located
from .named import balance_of
from .signature import Dependence, dependences
from .slow_state import RUN
from .trace import Trace

#: What is left of a mean square by a logged channel, of what the best other coordinate leaves.
CLEARLY = 0.9

#: What is added to the name of a channel that is called as a coordinate is.
AS_LOGGED = " as logged"

ByBalance = Mapping[str, Sequence[Dependence]]


def told_apart(
    logged: Mapping[str, np.ndarray], along: Mapping[str, np.ndarray]
) -> dict[str, np.ndarray]:
    """Channels by names that are none of the coordinates `along`, nor of what else is asked."""
    return {f"{n}{AS_LOGGED}" if n in along or n in LAST else n: x for n, x in logged.items()}


def on_logged(
    learned: Sequence[Trace], tested: Sequence[Trace], together: bool = False
) -> tuple[Dependence, ...]:
    """Dependences on what was logged beside, largest held-out gain first."""
    if not all(t.logged for t in (*learned, *tested)):
        return ()
    fit, select = ([replace(t, coordinates=t.logged) for t in ts] for ts in (learned, tested))
    return tuple(dependences(fit, select, together=together))


def with_logged(before: ByBalance, logged: ByBalance) -> tuple[dict[str, tuple], tuple[str, ...]]:
    """`before` with the channels that tell clearly more, and these as ``balance:coordinate``.

    Parameters
    ----------
    before, logged : mapping of str to sequence of Dependence
        Of the coordinates that are always asked, and of the channels.
    """
    shown, told = {b: tuple(found) for b, found in before.items()}, []
    for balance, asked in logged.items():
        others = {d.coordinate: d.gain for d in before.get(balance, ())}
        slow = others.pop(RUN, 0.0)
        best = max([0.0, *others.values()])
        named = {f"{balance}:{d.coordinate}": d for d in asked}
        sure = located([replace(d, coordinate=name) for name, d in named.items()])
        for name in sure:
            gain = named[name].gain
            if 1.0 - gain <= CLEARLY * (1.0 - best) and gain >= BESIDE_SLOW * slow:
                told.append(name)
        shown[balance] = (*(named[n] for n in told if n in named), *shown.get(balance, ()))
    return shown, tuple(told)


def instead(coordinates: Sequence[str], told: Sequence[str]) -> tuple[str, ...]:
    """Coordinates of an unknown, with logged channels `told` in place of their balance's own."""
    if not told:
        return tuple(coordinates)
    gone = {balance_of(name) for name in told} | set(LAST)
    return (*told, *(c for c in coordinates if not set(c.split(":")) & gone))
