"""A motor's driver that follows what it is told late."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DriveLag(Effect):
    """Adds ``constant (followed - told)``: the motor does what is told through a first-order lag.

    Told is the held input of the coordinate's drive; a released one does nothing.  Some stage of
    the controller has to write it (a servo, a recording).

    Parameters
    ----------
    lag : float
        Time constant [s].
    constant : float
        Force for each volt [N m/V or N/V]: the constant of the coordinate's ``force-drive``, that
        over the resistance of its ``voltage-drive``.
    begun : float
        What had been told for long when the run begins [V].  A diagnosis gives each run that
        begins in motion its own.
    """

    lag: float = parameter("time", 0.0, low=0.0, typical=0.005)
    constant: float = parameter("force a volt", 1.0)
    begun: float = parameter("voltage", 0.0)

    #: What the motor does beyond `begun` [V].
    states: ClassVar[tuple[str, ...]] = ("followed",)
    sizes: ClassVar[tuple[str, ...]] = ("lag",)
    family: ClassVar[str] = "drive timing"
    acts_on: ClassVar[str] = "actuator"
    of_motor: ClassVar[tuple[str, ...]] = ("constant",)
    reveals: ClassVar[str] = "Steps and fast sines of the drive, against the motion they make."

    @staticmethod
    def force(held, at_drive_1, at_open_1, coordinate, followed, lag, constant, begun):
        j = int(coordinate)
        if lag <= 0.0 or held[at_open_1 + j] > 0.0:
            return 0.0
        return constant * (begun + followed - held[at_drive_1 + j])

    @staticmethod
    def followed_rate(held, at_drive_1, at_open_1, coordinate, followed, lag, begun):
        j = int(coordinate)
        told = held[at_drive_1 + j] if held[at_open_1 + j] == 0.0 else 0.0
        return (told - begun - followed) / lag if lag > 0.0 else 0.0
