"""Weights of two links in a row, by their angles in space."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..applied_load import Load
from ..part import index, parameter


@dataclass(frozen=True)
class LinkWeights(Load):
    """Gravity on two links of a planar arm whose outer angle is relative to the inner link.

    A weight goes by its link's angle in space, the outer one's by the sum of both, and turns the
    inner joint as well.  On a model with the right weights it is what another direction of gravity
    adds: a base that is tilted.

    Parameters
    ----------
    cosine_1, sine_1, cosine_2, sine_2 : float
        Moments ``cosine cos + sine sin`` of inner and outer link [N m].
    outer : float
        Number of the outer link's coordinate, from 0; the inner one's is that before it.

    Raises
    ------
    ValueError
        If there is none before it.
    """

    cosine_1: float = parameter("torque", 0.0)
    sine_1: float = parameter("torque", 0.0)
    cosine_2: float = parameter("torque", 0.0)
    sine_2: float = parameter("torque", 0.0)
    outer: float = index("coordinate", 1.0)

    def __post_init__(self) -> None:
        if self.outer < 1.0:
            raise ValueError("outer: the first coordinate has no link before it")

    @staticmethod
    def force(q, Q, cosine_1, sine_1, cosine_2, sine_2, outer):
        j = int(outer)
        inner = q[j - 1]
        both = inner + q[j]
        far = cosine_2 * math.cos(both) + sine_2 * math.sin(both)
        Q[j - 1] += cosine_1 * math.cos(inner) + sine_1 * math.sin(inner) + far
        Q[j] += far
