"""What pushes: forces on the tip or along coordinates, a mass that the tip carries."""

from __future__ import annotations

from dataclasses import dataclass

from .part import Part


@dataclass(frozen=True)
class Load(Part):
    """Base of loads: a static ``tip_force(..., out)``, ``force(..., Q)`` or ``tip_inertia(...)``.

    ``tip_force`` writes the force on the tip to ``out`` (2,) [N]; ``force`` adds
    generalized forces to ``Q`` (n,); ``tip_inertia`` returns a mass at the tip [kg], constant in
    time.  Names as for controllers, and ``held_<name>`` for held inputs.
    """

    def breakpoints(self) -> tuple[float, ...]:
        """Instants at which the force is not smooth [s]; they end segments."""
        return ()
