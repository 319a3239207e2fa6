"""Located conditions that end a run.

Such a part has a static ``guard(...)``, which returns a number above 0 while the run goes on; the
run ends where it falls through 0.  It asks by name for ``time`` [s], ``q`` (n,) [rad or m], ``qd``
(n,) [rad/s or m/s], ``p`` (all parameters), ``s`` (scratch), ``held`` inputs, its parameters, and
any function of the device.  ``code`` is 2 where that end is meant and 3 where the run has then
failed; ``reason`` says why.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .part import Part, index, parameter


def _check_side(side: float) -> None:
    if side not in (-1.0, 1.0):
        raise ValueError(f"side: {side:g} is no direction; write 1 or -1")


@dataclass(frozen=True)
class TipPassesX(Part):
    """Stop when the tip's x falls below (side = 1) or rises above (side = -1) ``x`` [m].

    Source: thesis 5.2.1 (a line of constant x ends the run).
    """

    x: float = parameter("length", 0.0)
    side: float = parameter("dimensionless", 1.0, low=-1.0, high=1.0)

    code: ClassVar[int] = 2
    reason: ClassVar[str] = "tip reached the stop line"

    def __post_init__(self) -> None:
        _check_side(self.side)

    @staticmethod
    def guard(q, p, s, tip, x, side):
        point = s[0:2]
        tip(q, p, point)
        return side * (point[0] - x)


@dataclass(frozen=True)
class Singular(Part):
    """Fail before a singular pose (links aligned) is met."""

    margin: float = parameter("dimensionless", 0.02, above=0.0, high=1.0)

    code: ClassVar[int] = 3
    reason: ClassVar[str] = "singular pose ahead"

    @staticmethod
    def guard(q, p, singularity, margin):
        return abs(singularity(q, p)) - margin


@dataclass(frozen=True)
class CoordinateLimit(Part):
    """Stop when coordinate number ``index`` (from 0) passes ``limit`` in the direction ``side``."""

    index: float = index("coordinate", 0.0)
    limit: float = parameter("coordinate", 0.0)
    side: float = parameter("dimensionless", 1.0, low=-1.0, high=1.0)

    code: ClassVar[int] = 2
    reason: ClassVar[str] = "coordinate reached its limit"

    def __post_init__(self) -> None:
        _check_side(self.side)

    @staticmethod
    def guard(q, index, limit, side):
        return side * (limit - q[int(index)])
