"""Breakaway that depends on how fast the load rises."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class RateBreakaway(Effect):
    """Breakaway torque divided by ``1 + fall ln(1 + slope/scale)``; the slope of the load's size
    is its derivative filtered twice.

    Of a breakaway torque that was measured at a slope (``reference``) the quotient there is 1.
    In a redundantly stuck set the load of one clutch is a convention.

    Source: R. Johannes, M. Green, C. Brockley, Wear 24 (1973) 381.

    Parameters
    ----------
    fall : float
        Relative fall a factor e of slope.
    scale : float
        Slope from which the fall is logarithmic [N m/s or N/s].
    filter : float
        Time constant of both filters [s].
    reference : float
        Slope at which nothing changes [N m/s or N/s].
    """

    fall: float = parameter("dimensionless", 0.0, low=0.0, high=1.0, typical=0.02)
    scale: float = parameter("coordinate force rate", 1.0, above=0.0, typical=1.0)
    filter: float = parameter("time", 0.02, above=0.0)
    reference: float = parameter("coordinate force rate", 0.0, low=0.0)

    states: ClassVar[tuple[str, ...]] = (
        "near",
        "far",
    )
    sizes: ClassVar[tuple[str, ...]] = ("fall",)
    family: ClassVar[str] = "breakaway rate"
    acts_on: ClassVar[str] = "breakaway"
    reveals: ClassVar[str] = "Torque ramps to breakaway at slopes over two decades."

    @staticmethod
    def break_torque(torque, near, far, fall, scale, filter, reference):
        slope = max(near - far, 0.0) / filter
        declared = 1.0 + fall * math.log(1.0 + reference / scale)
        return torque * declared / (1.0 + fall * math.log(1.0 + slope / scale))

    @staticmethod
    def near_rate(torque, near, filter):
        return (abs(torque) - near) / filter

    @staticmethod
    def far_rate(near, far, filter):
        return (near - far) / filter
