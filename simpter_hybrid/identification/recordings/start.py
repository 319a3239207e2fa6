"""State in which runs begin, where a map tells it: a record shows it with noise, a stop exactly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ...problems import InvalidInput, Problem
from ...reading.reader import TableReader
from .channel_map import ChannelMap
from .map_units import si_difference

POSITION, SPEED = "position", "speed"


@dataclass(frozen=True)
class Start:
    """What is known of the first row of each run; None of what the record has to tell.

    Of the model's coordinate: sign and offset of a channel are not applied.

    Parameters
    ----------
    position : float or None
        [rad or m].
    speed : float or None
        [rad/s or m/s].
    """

    position: float | None = None
    speed: float | None = None

    def __str__(self) -> str:
        known = ((name, value) for name, value in vars(self).items() if value is not None)
        return ", ".join(f"{name} {value:g}" for name, value in known)

    @property
    def told(self) -> tuple[bool, bool]:
        """Whether position and speed are known."""
        return self.position is not None, self.speed is not None

    def put_right(self, read: Sequence[float]) -> tuple[float, float]:
        """Position and speed as `read` from a record, or as told."""
        known = self.position, self.speed
        position, speed = (r if k is None else k for r, k in zip(read, known, strict=True))
        return float(position), float(speed)


def read_start(table: TableReader, channels: Mapping[str, ChannelMap], begins: float) -> Start:
    """Start of runs by the ``[start]`` table of a map whose rows count from `begins` on [s].

    Of what no channel shows there is nothing to be told by: without positions the place of a start
    is arbitrary.
    """
    if table.data and begins:
        right = "no [start], or rows from a run's first on"
        table.problem(next(iter(table.data)), "of the first rows, which do not count", right)
    place, rate = channels.get(POSITION), channels.get(SPEED)
    if POSITION in table and place is None:
        table.problem(POSITION, "no channel of that name", "a channel called position beside it")
    unit = "" if place is None else place.unit
    position = _quantity(table, POSITION, unit)
    unit = rate.unit if rate is not None else f"{unit}/s" if unit else ""
    return Start(position, _quantity(table, SPEED, unit))


def refuse_start(start: Start, source: str, rig: str) -> None:
    """A told start is of no use on some rigs.

    Raises
    ------
    InvalidInput
        If one is told.
    """
    if any(start.told):
        right = "no [start]: it is read from the record; it may be told of one axis"
        what = f"the state in which runs begin cannot be told of {rig}"
        raise InvalidInput([Problem(source, "start", what, str(start), right)])


def _quantity(table: TableReader, key: str, unit: str) -> float | None:
    if key not in table:
        table.raw(key, None)
        return None
    if not unit:
        table.raw(key, None)
        return 0.0  # what is wrong is said of its channel
    return float(si_difference(table, key, unit, 0.0))
