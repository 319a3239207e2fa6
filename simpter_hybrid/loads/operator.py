"""The thesis's virtual operator: a constant push along the path and sinusoids normal to it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..applied_load import Load
from ..part import counted, parameter, rows


@dataclass(frozen=True)
class Operator(Load):
    """Constant force along a direction plus a sum of sinusoids normal to it (thesis 5.2.1).

    Parameters
    ----------
    along : float
        Constant force [N].
    angle : float
        Direction of the constant force from the x axis [rad]; sinusoids act at +90 degrees to it.
    lines : tuple of (float, float, float)
        Amplitude [N], frequency [Hz] and phase [rad] of every sinusoid; sine functions of time.
    """

    along: float = parameter("force")
    angle: float = parameter("angle")
    lines: tuple[tuple[float, float, float], ...] = rows(
        ("amplitude", "force"), ("frequency", "frequency"), ("phase", "angle"), default=()
    )

    def table(self) -> tuple[float, ...]:
        """Number of lines, then the lines."""
        return counted(self.lines)

    @staticmethod
    def tip_force(time, p, table_at, along, angle, out):
        normal = 0.0
        for k in range(int(p[table_at])):
            at = table_at + 1 + 3 * k
            normal += p[at] * math.sin(2.0 * math.pi * p[at + 1] * time + p[at + 2])
        c = math.cos(angle)
        s = math.sin(angle)
        out[0] = along * c - normal * s
        out[1] = along * s + normal * c
