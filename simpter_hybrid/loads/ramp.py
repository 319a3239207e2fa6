"""A torque on one coordinate that is constant or rises linearly."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load
from ..part import index, parameter


@dataclass(frozen=True)
class RampOnCoordinate(Load):
    """``base + slope (t - start)`` from ``start`` on, never beyond ``limit``; before it ``base``.

    Source: thesis 4.6.2.2 (ramped motor torque) and 5.4.3 (constant 250 lb-in).

    Parameters
    ----------
    base : float
        Constant part [N m].
    slope : float
        [N m/s].
    start : float
        [s].
    limit : float
        The torque the ramp ends at [N m].
    coordinate : float
        Number of the coordinate, from 0.
    """

    base: float = parameter("coordinate force")
    slope: float = parameter("coordinate force rate", 0.0)
    start: float = parameter("time", 0.0)
    limit: float = parameter("coordinate force", 1e300)
    coordinate: float = index("coordinate", 0.0)

    def breakpoints(self) -> tuple[float, ...]:
        """Start and end of the ramp [s]."""
        if self.slope == 0.0:
            return ()
        end = self.start + (self.limit - self.base) / self.slope
        return (self.start, end) if end > self.start else (self.start,)

    @staticmethod
    def force(time, Q, base, slope, start, limit, coordinate):
        risen = slope * max(time - start, 0.0)
        most = limit - base
        # A falling ramp has a limit below its base.
        Q[int(coordinate)] += base + (min(risen, most) if slope >= 0.0 else max(risen, most))
