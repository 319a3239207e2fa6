"""A device: n generalized coordinates, m friction surfaces, four functions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .part import Part

#: What a coordinate may measure.
COORDINATE_KINDS = ("angle", "length")


@dataclass(frozen=True)
class Device(Part):
    """Base of every device.

    A subclass names its ``coordinates`` and ``surfaces``, declares its parameters as ``float``
    fields, and defines four static functions (flat row-major arrays, written in place; ``p`` holds
    the parameters in the order of the fields):

    ``mass_matrix(q, p, out)``
        M, n*n [kg m^2 or kg].
    ``velocity_terms(q, qd, p, out)``
        V of ``M qdd + V = C^T tau + Q``, n [N m or N].
    ``clutch_map(q, p, out)``
        C of the slip velocities ``w = C qd`` [rad/s or m/s], m*n.
    ``clutch_map_rate(q, qd, p, out)``
        Cdot qd, m [rad/s^2 or m/s^2].

    ``q`` and ``qd`` hold n coordinates [rad or m] and their speeds [rad/s or m/s].

    Optional: ``conservative_force(q, p, out)`` (-dU/dq, n [N m or N]) with
    ``potential_energy(q, p)`` (returns U [J]);
    ``damping_force(q, qd, p, out)`` (n [N m or N]; its work counts with that of effects);
    ``tip(q, p, out)``, ``tip_jacobian(q, p, out)``, ``tip_jacobian_rate(q, qd, p, out)``
    (position, 2 [m]; its Jacobian J, 2*n [m/rad or 1]; Jdot qd, 2 [m/s^2]);
    ``singularity(q, p)`` (returns a number that falls through 0 at a singular pose).
    """

    coordinates: ClassVar[tuple[str, ...]] = ()
    #: One of ``COORDINATE_KINDS`` for every coordinate; empty: all are angles.
    coordinate_dimensions: ClassVar[tuple[str, ...]] = ()
    surfaces: ClassVar[tuple[str, ...]] = ()
    #: Whether the clutch map is the same in every configuration.
    constant_clutch_map: ClassVar[bool] = True

    def __init_subclass__(cls, **named: object) -> None:
        super().__init_subclass__(**named)
        taken = {"n", "m", "surface_units"} & vars(cls).get("__annotations__", {}).keys()
        if taken:
            raise TypeError(
                f"{cls.__name__}: {', '.join(sorted(taken))} cannot be the name of a parameter, "
                "since every device has its numbers n and m; take a longer name"
            )

    @property
    def n(self) -> int:
        """Number of generalized coordinates."""
        return len(self.coordinates)

    @property
    def m(self) -> int:
        """Number of friction surfaces."""
        return len(self.surfaces)

    @property
    def surface_units(self) -> tuple[str, str]:
        """SI units of slip velocities and of the surfaces' torques or forces.

        Surfaces rub along lengths where all coordinates are lengths, else over angles.
        """
        kinds = set(self.coordinate_dimensions)
        return ("m/s", "N") if kinds == {"length"} else ("rad/s", "N m")

    def case_of(self, mode: tuple[int, ...]) -> str:
        """A name for the combination of clutch modes in event logs; '' where there is none.

        Parameters
        ----------
        mode : tuple of int, (m,)
            BACKWARD -1, STICK 0, FORWARD 1, FREE 2.
        """
        return ""


def wrong_dimensions(given: object, count: int) -> tuple[str, str] | None:
    """What is wrong with ``coordinate_dimensions``, and what would be right; None if nothing is.

    Parameters
    ----------
    given : object
        As a device has them.
    count : int
        Coordinates.
    """
    each = " or ".join(map(repr, COORDINATE_KINDS))
    right = f"a tuple of {count}, each {each}; or an empty one if all are angles"
    if not isinstance(given, tuple | list):
        return "not a tuple", right
    unknown = [word for word in given if word not in COORDINATE_KINDS]
    if unknown:
        return f"{unknown[0]!r} is nothing that a coordinate measures", right
    if given and len(given) != count:
        return f"{len(given)} for {count} coordinate{'s' if count != 1 else ''}", right
    return None


def surface_word(unit: str) -> str:
    """What surfaces transmit, by its SI unit: ``force`` or ``torque``.

    Parameters
    ----------
    unit : str
        The second of ``Device.surface_units``.
    """
    return "force" if unit == "N" else "torque"
