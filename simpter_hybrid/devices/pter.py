"""PTER: the two-link passive haptic robot of the thesis, with its four clutches."""

from __future__ import annotations

import math
from collections.abc import Sequence
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

    def drawing(self, q: Sequence[float]) -> list[list[tuple[float, float]]]:
        """The links as polylines [m], for pictures: B and C, then A, then D with the tip last.

        The length of link B does not enter the equations; it is drawn as half of link A.

        Parameters
        ----------
        q : sequence of float (2,)
            theta_1 and theta_2 [rad].
        """
        along, across = (math.cos(q[0]), math.sin(q[0])), (-math.sin(q[1]), math.cos(q[1]))
        l_b = 0.5 * self.l_a

        def at(a: float, d: float) -> tuple[float, float]:
            return (a * along[0] + d * across[0], a * along[1] + d * across[1])

        return [
            [at(0.0, 0.0), at(0.0, -l_b), at(self.l_a, -l_b)],
            [at(0.0, 0.0), at(self.l_a, 0.0)],
            [at(self.l_a, -l_b), at(self.l_a, self.l_d)],
        ]

    def case_of(self, mode: tuple[int, ...]) -> str:
        """Thesis case number (Tables 1 and 2) of four clutch modes."""
        return CASES[tuple(i + 1 for i in range(4) if mode[i] == 0)]

    @property
    def reach(self) -> tuple[float, float]:
        """Least and greatest distance of the tip from the origin [m]."""
        return abs(self.l_a - self.l_d), self.l_a + self.l_d

    def pose(self, x: float, y: float, positive: bool = True) -> tuple[float, float] | None:
        """Coordinates [rad] that put the tip at (x, y) [m]; None if it is out of reach.

        ``positive`` takes the elbow with det J >= 0, the one of the thesis's figures.

        Parameters
        ----------
        x, y : float
            [m].
        positive : bool
            Which elbow.
        """
        q = [0.0, 0.0]
        p = [self.alpha, self.beta, self.gamma, self.l_a, self.l_d]
        status = equations.inverse_kinematics(x, y, 1 if positive else -1, p, q)
        return None if status else (q[0], q[1])
