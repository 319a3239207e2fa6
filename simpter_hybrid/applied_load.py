"""What pushes: forces on the tip or along coordinates, a mass that the tip carries."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from .part import Part


@dataclass(frozen=True)
class Load(Part):
    """Base of loads: a static ``tip_force(..., out)``, ``force(..., Q)`` or ``tip_inertia(...)``.

    ``tip_force(..., out)``
        Writes the force on the tip to ``out`` (2,) [N].
    ``force(..., Q)``
        Adds generalized forces to ``Q`` (n,) [N m or N].
    ``tip_inertia(...)``
        Returns a mass at the tip [kg], constant in time.

    Each asks by name for what it uses: names as for controllers (``time`` [s], ``q`` [rad or m] and
    ``qd`` [rad/s or m/s] (n,), ``p``, parameters), and ``held_<name>`` for held inputs.
    """

    def breakpoints(self) -> tuple[float, ...]:
        """Instants at which the force is not smooth [s]; they end segments."""
        return ()

    def jumps(self) -> tuple[float, ...]:
        """Those of the ``breakpoints`` at which the force itself jumps [s].

        At one of them ``force`` gives what comes after it; the segment before it ends an instant
        earlier.
        """
        return ()

    def knots(self) -> tuple[float, ...]:
        """Instants at which a smooth force's curvature jumps [s], rising.

        A long step across one is less accurate than its tolerance says: those far apart end
        segments too (`far_apart`). Those close together would cost more than they give.
        """
        return ()


def far_apart(knots: Sequence[float], max_step: float) -> list[float]:
    """The knots that are more than a longest step from a neighbour, and the first and last.

    Between others every step would be cut short: a run would take many times its steps.

    Parameters
    ----------
    knots : sequence of float
        Rising [s].
    max_step : float
        Longest step [s].
    """
    # A distance of just the longest step is not beyond it, whatever rounding makes of it.
    apart = max_step * (1.0 + 1e-6)
    if not knots:
        return []
    before, after = (-math.inf, *knots[:-1]), (*knots[1:], math.inf)
    return [
        t
        for last, t, following in zip(before, knots, after, strict=True)
        if t - last > apart or following - t > apart
    ]
