"""A torque on one coordinate that is constant or rises linearly."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load
from ..part import index, parameter

#: Beyond any torque: a ramp without an end, whichever way it leads.
NO_LIMIT = 1e300


@dataclass(frozen=True)
class RampOnCoordinate(Load):
    """``base + slope (t - start)`` from ``start`` on, never beyond ``limit``; before it ``base``.

    Without a slope it is ``base`` throughout, whatever the limit.

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
        The torque the ramp ends at [N m]; left out, it has no end.
    coordinate : float
        Number of the coordinate, from 0.

    Raises
    ------
    ValueError
        If the ramp leads away from its limit.
    """

    base: float = parameter("coordinate force")
    slope: float = parameter("coordinate force rate", 0.0)
    start: float = parameter("time", 0.0)
    limit: float = parameter("coordinate force", NO_LIMIT)
    coordinate: float = index("coordinate", 0.0)

    def __post_init__(self) -> None:
        if self.limit < NO_LIMIT and (self.limit - self.base) * self.slope < 0.0:
            way, side = ("rises", "above") if self.slope > 0.0 else ("falls", "below")
            raise ValueError(
                f"limit: {self.limit:g} N m (or N) is not {side} the base, {self.base:g}, though "
                f"the ramp {way}; give one {side} it, or leave it out"
            )

    def breakpoints(self) -> tuple[float, ...]:
        """Start and end of the ramp [s]."""
        if self.slope == 0.0:
            return ()
        end = self.start + (self.limit - self.base) / self.slope
        return (self.start, end) if end > self.start else (self.start,)

    @staticmethod
    def force(time, Q, base, slope, start, limit, coordinate):
        risen = slope * max(time - start, 0.0)
        # A falling ramp has a limit below its base, and without a limit falls for ever.
        most = -1e300 if slope < 0.0 and limit >= 1e300 else limit - base
        if slope > 0.0:
            risen = min(risen, most)
        elif slope < 0.0:
            risen = max(risen, most)
        Q[int(coordinate)] += base + risen
