"""Servos of an axis: position and speed loops that write the drive's voltage."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..loads.piecewise import check_rising, straight_value
from ..part import counted, index, parameter, rows

#: Held inputs that drives read, one for each coordinate: voltage, and 1 while the motor's terminals
#: are open.
DRIVE_INPUTS = ("drive", "open")
#: Those of two coordinates.
HOLDS = ("drive_1", "drive_2", "open_1", "open_2")
#: What a position servo remembers: two positions, the instant of the last, 1 once it has begun, and
#: the integral.
MEMORY = ("last", "before", "instant", "started", "integral")


def drive_inputs(coordinate: float) -> tuple[str, ...]:
    """Held inputs as far as a coordinate's, of the first two at least.

    Parameters
    ----------
    coordinate : float
        Its number, from 0.
    """
    count = max(int(coordinate) + 1, 2)
    return tuple(f"{name}_{j + 1}" for name in DRIVE_INPUTS for j in range(count))


def position_servo(
    wanted, time, at, speed, mem, mem_at, proportional, integral_gain, derivative, limit,
    differenced,
):  # fmt: skip
    """Voltage of `PositionServo` for a set point, a position and a speed.

    Parameters
    ----------
    wanted, at : float
        Set point and position [rad or m].
    time : float
        [s].
    speed : float
        [rad/s or m/s]; not used where it is ``differenced``.
    mem : array
        Memory; five cells, as `MEMORY` names them, are written.
    mem_at : int
        The first of them.
    proportional, integral_gain, derivative, limit, differenced : float
        Those of `PositionServo`.

    Returns
    -------
    float
        [V].
    """
    if mem[mem_at + 3] == 0.0:
        mem[mem_at] = at
        mem[mem_at + 1] = at
        mem[mem_at + 2] = time
        mem[mem_at + 3] = 1.0
    passed = time - mem[mem_at + 2]
    if differenced > 0.0:
        speed = (at - mem[mem_at + 1]) / (2.0 * passed) if passed > 0.0 else 0.0
        mem[mem_at + 1] = mem[mem_at]
        mem[mem_at] = at
    total = mem[mem_at + 4] + integral_gain * passed * (wanted - at)
    total = min(max(total, -limit), limit)
    mem[mem_at + 2] = time
    mem[mem_at + 4] = total
    return min(max(proportional * (wanted - at) - derivative * speed + total, -limit), limit)


@dataclass(frozen=True)
class PositionServo(Controller):
    """``u = proportional e - derivative speed + integral of (integral_gain e)``; sampled.

    ``e`` is the reference less the position; the sum and the integral are limited.

    Parameters
    ----------
    points : tuple of (float, float)
        Reference: instants [s], rising, and positions [rad or m]; straight between.
    proportional : float
        [V/rad or V/m].
    derivative : float
        [V s/rad or V s/m].
    limit : float
        Largest voltage, and largest integral [V].
    differenced : float
        1: speed from the mean of two positions, differenced; 0: the true speed.
    release : float
        Instant from which the motor's terminals are open [s].
    coordinate : float
        Number of the coordinate, from 0.
    integral_gain : float
        [V/(rad s) or V/(m s)].
    delay : float
        The reference that acts is that of so long ago [s].
    """

    points: tuple[tuple[float, float], ...] = rows(("time", "time"), ("position", "coordinate"))
    proportional: float = parameter("coordinate gain")
    derivative: float = parameter("coordinate speed gain", 0.0)
    limit: float = parameter("voltage", 1e300, above=0.0)
    differenced: float = parameter("dimensionless", 0.0, low=0.0, high=1.0)
    release: float = parameter("time", 1e300)
    coordinate: float = index("coordinate", 0.0)
    integral_gain: float = parameter("coordinate integral gain", 0.0)
    delay: float = parameter("time", 0.0, low=0.0, typical=0.005)

    uses: ClassVar[tuple] = (straight_value, position_servo)
    holds: ClassVar[tuple[str, ...]] = HOLDS
    memory: ClassVar[tuple[str, ...]] = MEMORY

    def __post_init__(self) -> None:
        check_rising(self.points)

    def held_inputs(self) -> tuple[str, ...]:
        """Those of the coordinates as far as its own."""
        return drive_inputs(self.coordinate)

    def table(self) -> tuple[float, ...]:
        """Number of points, then the points."""
        return counted(self.points)

    @staticmethod
    def step(
        time, q, qd, p, table_at, held, at_drive_1, at_open_1, mem, mem_at, proportional,
        derivative, limit, differenced, release, coordinate, integral_gain, delay,
    ):  # fmt: skip
        j = int(coordinate)
        wanted = straight_value(p, table_at + 1, int(p[table_at]), 2, 1, time - delay)
        held[at_drive_1 + j] = position_servo(
            wanted, time, q[j], qd[j], mem, mem_at, proportional, integral_gain, derivative, limit,
            differenced,
        )  # fmt: skip
        held[at_open_1 + j] = 1.0 if time >= release else 0.0


@dataclass(frozen=True)
class AxisSpeedServo(Controller):
    """``u = proportional e + integral of (integral_gain e)``, both limited; e: error of speed.

    Parameters
    ----------
    points : tuple of (float, float)
        Reference: instants [s], rising, and speeds [rad/s or m/s]; straight between.
    proportional : float
        [V s/rad or V s/m].
    integral_gain : float
        [V/rad or V/m].
    limit : float
        Largest voltage, and largest integral [V].
    coordinate : float
        Number of the coordinate, from 0.
    """

    points: tuple[tuple[float, float], ...] = rows(("time", "time"), ("speed", "coordinate speed"))
    proportional: float = parameter("coordinate speed gain")
    integral_gain: float = parameter("coordinate gain", 0.0)
    limit: float = parameter("voltage", 1e300, above=0.0)
    coordinate: float = index("coordinate", 0.0)

    uses: ClassVar[tuple] = (straight_value,)
    holds: ClassVar[tuple[str, ...]] = HOLDS
    memory: ClassVar[tuple[str, ...]] = ("instant", "integral")

    def __post_init__(self) -> None:
        check_rising(self.points)

    def held_inputs(self) -> tuple[str, ...]:
        """Those of the coordinates as far as its own."""
        return drive_inputs(self.coordinate)

    def table(self) -> tuple[float, ...]:
        """Number of points, then the points."""
        return counted(self.points)

    @staticmethod
    def step(
        time, qd, p, table_at, held, at_drive_1, mem, mem_at, proportional, integral_gain, limit,
        coordinate,
    ):  # fmt: skip
        j = int(coordinate)
        error = straight_value(p, table_at + 1, int(p[table_at]), 2, 1, time) - qd[j]
        total = mem[mem_at + 1] + integral_gain * (time - mem[mem_at]) * error
        total = min(max(total, -limit), limit)
        mem[mem_at] = time
        mem[mem_at + 1] = total
        held[at_drive_1 + j] = min(max(proportional * error + total, -limit), limit)
