"""The command of a clutch that the model does not have, but that hangs on the same supply."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import counted, rows
from .profile import check_course, profiled


@dataclass(frozen=True)
class NeighbourProfile(Controller):
    """Command of a neighbour, straight between given points: what ``effects.neighbour_command``
    asks for.

    Parameters
    ----------
    points : tuple of (float, float)
        Time [s] and command [V]; two points at one time are a step. Constant outside.

    Raises
    ------
    ValueError
        If there is no point or time runs backwards.
    """

    points: tuple[tuple[float, float], ...] = rows(("time", "time"), ("command", "voltage"))

    holds: ClassVar[tuple[str, ...]] = ("neighbour_command",)
    uses: ClassVar[tuple] = (profiled,)

    def __post_init__(self) -> None:
        check_course(self.points)

    def table(self) -> tuple[float, ...]:
        """Number of points, then the points."""
        return counted(self.points)

    @staticmethod
    def step(time, p, table_at, held, at_neighbour_command):
        held[at_neighbour_command] = profiled(p, table_at, time)
