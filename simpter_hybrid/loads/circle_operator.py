"""The operator of the first simulation: a push along a circle and a periodic radial force."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..applied_load import Load
from ..part import parameter


@dataclass(frozen=True)
class CircleOperator(Load):
    """Force along the tangent at the tip plus a sinusoid along the radius (thesis 2.3).

    Parameters
    ----------
    along : float
        Tangential force, positive anticlockwise [N].
    amplitude : float
        Of the radial force [N].
    frequency : float
        [Hz].
    phase : float
        [rad].
    x, y : float
        Centre of the circle [m].
    """

    along: float = parameter("force")
    amplitude: float = parameter("force")
    frequency: float = parameter("frequency", low=0.0)
    phase: float = parameter("angle")
    x: float = parameter("length")
    y: float = parameter("length")

    @staticmethod
    def tip_force(time, q, p, tip, along, amplitude, frequency, phase, x, y, out):
        tip(q, p, out)
        away = math.hypot(out[0] - x, out[1] - y)
        nx = (out[0] - x) / away if away > 0.0 else 1.0
        ny = (out[1] - y) / away if away > 0.0 else 0.0
        radial = amplitude * math.sin(2.0 * math.pi * frequency * time + phase)
        out[0] = radial * nx - along * ny
        out[1] = radial * ny + along * nx
