"""PTER: the two-link passive haptic robot of the thesis, with its four clutches."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..device import Device
from ..part import parameter
from . import pter_equations as equations

#: Thesis Tables 1, 2 and 7, by the set of stuck clutches.
CASES = {
    (): "1",
    (1,): "2.1",
    (2,): "2.2",
    (3,): "3.1",
    (4,): "3.2",
    (1, 3): "4.1",
    (1, 4): "4.2",
    (2, 3): "4.3",
    (2, 4): "4.4",
    (1, 2): "5",
    (3, 4): "6",
    (1, 2, 3): "7.1",
    (1, 2, 4): "7.2",
    (1, 3, 4): "7.3",
    (2, 3, 4): "7.4",
    (1, 2, 3, 4): "7.5",
}


@dataclass(frozen=True)
class Pter(Device):
    """PTER in the reduced inertia parameters of the thesis's equations (12)-(15).

    Parameters
    ----------
    alpha, beta, gamma : float
        Equations (12)-(14) [kg m^2].
    l_a, l_d : float
        Lengths of links A and D [m].
    """

    alpha: float = parameter("inertia", above=0.0)
    beta: float = parameter("inertia", above=0.0)
    gamma: float = parameter("inertia")
    l_a: float = parameter("length", above=0.0)
    l_d: float = parameter("length", above=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("theta_1", "theta_2")
    surfaces: ClassVar[tuple[str, ...]] = ("clutch 1", "clutch 2", "clutch 3", "clutch 4")

    mass_matrix = staticmethod(equations.mass_matrix)
    velocity_terms = staticmethod(equations.velocity_terms)
    clutch_map = staticmethod(equations.clutch_map)
    clutch_map_rate = staticmethod(equations.clutch_map_rate)
    tip = staticmethod(equations.tip)
    tip_jacobian = staticmethod(equations.tip_jacobian)
    tip_jacobian_rate = staticmethod(equations.tip_jacobian_rate)
    singularity = staticmethod(equations.singularity)

    def case_of(self, mode: tuple[int, ...]) -> str:
        """Thesis case number (Tables 1 and 2) of four clutch modes."""
        return CASES[tuple(i + 1 for i in range(4) if mode[i] == 0)]
