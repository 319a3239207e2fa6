"""A pressure on a piston."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load
from ..part import index, parameter


@dataclass(frozen=True)
class PistonForce(Load):
    """Pushes a coordinate back with ``area`` times the command of a clutch.

    That command stands for the pressure that also presses a seal (``CoulombViscous``): one volt for
    each unit of it, so that ``area`` is a force a volt.

    Parameters
    ----------
    area : float
        Force a volt of command [N/V].
    coordinate : float
        Number of the coordinate, from 0.
    clutch : float
        Number of the clutch, from 0.
    """

    area: float = parameter("force a volt", above=0.0)
    coordinate: float = index("coordinate", 0.0)
    clutch: float = index("clutch", 0.0)

    @staticmethod
    def force(held, Q, area, coordinate, clutch):
        Q[int(coordinate)] -= area * held[int(clutch)]
