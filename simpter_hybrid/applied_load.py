"""What pushes: forces on the tip or along coordinates, a mass that the tip carries."""

from __future__ import annotations

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
