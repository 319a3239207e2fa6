"""Breakaway that grows with the time at rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DwellBreakaway(Effect):
    """Breakaway torque times ``1 + rise ln(1 + age/onset)``; the contact's age grows with time
    at rest and is worn off by sliding: ``age' = 1 - |slip| age/distance``.

    Source: J. Dieterich's ageing law (Pure Appl. Geophys. 116 (1978) 790).

    Parameters
    ----------
    rise : float
        Relative rise a factor e of time at rest.
    onset : float
        Time from which the rise is logarithmic [s].
    distance : float
        Slip that renews the contacts [rad or m].
    """

    rise: float = parameter("dimensionless", 0.0, low=0.0, high=1.0, typical=0.02)
    onset: float = parameter("time", 0.1, above=0.0, typical=0.1)
    distance: float = parameter("coordinate", 0.01, above=0.0, typical=0.01)

    states: ClassVar[tuple[str, ...]] = ("age",)
    sizes: ClassVar[tuple[str, ...]] = ("rise",)
    family: ClassVar[str] = "dwell"
    acts_on: ClassVar[str] = "breakaway"
    reveals: ClassVar[str] = "Torque ramps to breakaway after dwells from 0.1 s to 30 s."

    @staticmethod
    def break_torque(torque, age, rise, onset):
        return torque * (1.0 + rise * math.log(1.0 + max(age, 0.0) / onset))

    @staticmethod
    def age_rate(age, speed, engaged, distance):
        return engaged * (1.0 - speed * age / distance) - (1.0 - engaged) * age / 0.01
