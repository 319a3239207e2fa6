"""A clutch's torque map from tabulated data."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from ..clutch import TorqueLaw
from ..interpolation import hermite_table, hermite_value, monotone_slopes
from ..part import rows


@dataclass(frozen=True)
class TableTorque(TorqueLaw):
    """Slip and breakaway torque through measured points; the curves rise where the points do.

    ``slip = curve(excitation) * factor(speed)``, both monotone cubic pieces with a continuous slope
    (``interpolation``), constant beyond their ends.

    Parameters
    ----------
    points : tuple of (float, float, float)
        Excitation [V], slip torque at zero speed (or at any, without ``factors``) and breakaway
        torque [N m or N]; rising excitation. Clutches are only valid if the table reaches from 0 V
        to their full scale.
    factors : tuple of (float, float)
        Slip speed [rad/s or m/s] and the factor on the slip torque there; rising speed.

    Raises
    ------
    ValueError
        If there are fewer than two points, or excitations or speeds do not rise.
    """

    points: tuple[tuple[float, float, float], ...] = rows(
        ("excitation", "voltage"),
        ("slip torque", "coordinate force"),
        ("breakaway torque", "coordinate force"),
    )
    factors: tuple[tuple[float, float], ...] = rows(
        ("speed", "coordinate speed"), ("factor", "dimensionless"), default=((0.0, 1.0),)
    )

    uses: ClassVar[tuple] = (hermite_value,)

    def __post_init__(self) -> None:
        if len(self.points) < 2:
            raise ValueError(
                f"points: a torque table of {len(self.points)} points; at least two are needed, "
                "from 0 V to full scale"
            )
        for name, unit, table in (("points", " V", self.points), ("factors", "", self.factors)):
            for a, b in pairwise(table):
                if b[0] <= a[0]:
                    raise ValueError(
                        f"{name}: {b[0]:g}{unit} follows {a[0]:g}{unit}; sort the points so "
                        "that the first column rises, and drop repeated ones"
                    )

    def table(self) -> tuple[float, ...]:
        """Numbers of points and factors, then both curves with their slopes."""
        return (
            float(len(self.points)),
            float(len(self.factors)),
            *hermite_table(self.points, monotone_slopes),
            *hermite_table(self.factors, monotone_slopes),
        )

    @staticmethod
    def slip_torque(speed, excitation, p, table_at):
        count = int(p[table_at])
        at = table_at + 2
        base = hermite_value(p, at, count, 5, 1, excitation)
        return base * hermite_value(p, at + 5 * count, int(p[table_at + 1]), 3, 1, speed)

    @staticmethod
    def break_torque(excitation, p, table_at):
        return hermite_value(p, table_at + 2, int(p[table_at]), 5, 3, excitation)
