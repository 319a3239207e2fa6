"""A position that is off by a wave of the angle, as an encoder off its axis shows it.

The speed beside it, summed up, does not have that wave; where each run began need not be known,
nor a zero of the speed: each run, or what is between two gaps of one, has a straight line of its
own.  Nor how late the speed is: what that makes of the difference goes along with the speed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.integrate import cumulative_trapezoid

from ...units import is_unit
from .channel_map import ChannelMap
from .checks import Finding
from .projection import beyond
from .recorded_run import RecordedRun
from .row_step import gaps

#: A position is off by a wave if that leaves this part of the mean square of its difference to the
#: summed speed ...
LEFT = 0.2
#: ... and this part of what a gain and a bend of the sensor would leave.
OF_OTHERS = 0.25
#: Columns of a run's table.
WAVE, OTHERS, RATE, CHANGE = slice(1, 3), slice(3, 5), slice(5, 6), 6
#: Fewest rows between gaps that are looked at: in fewer a straight line is most of a wave.
LEAST = 50


class OffAxis(NamedTuple):
    """A position that shows ``cosine cos(q) + sine sin(q)`` too much [rad]."""

    position: str
    speed: str
    cosine: float
    sine: float

    @property
    def size(self) -> float:
        """Amplitude of the wave [rad]."""
        return float(np.hypot(self.cosine, self.sine))


def off_axis(runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]) -> Iterator[OffAxis]:
    """Positions that differ from the speeds beside them by one wave a turn, in all runs alike."""
    for position, channel in channels.items():
        speed = position.replace("position", "speed", 1)
        if not position.startswith("position") or not is_unit(channel.unit, "angle"):
            continue
        if speed not in channels or {channel.role, channels[speed].role} != {"measured"}:
            continue
        apart = [
            _apart(run, position, speed) for run in runs if {position, speed} <= {*run.channels}
        ]
        apart = [one for one in apart if len(one) > LEAST]
        if len(apart) < 2:
            continue
        wave = _wave(apart) or _wave(*_in_time(apart))
        if wave is not None:
            yield OffAxis(position, speed, *wave)


def put_on_axis(runs: Sequence[RecordedRun], found: OffAxis) -> tuple[RecordedRun, ...]:
    """Runs whose position has not that wave."""
    made = []
    for run in runs:
        if (shown := run.channels.get(found.position)) is not None:
            right = shown - found.cosine * np.cos(shown) - found.sine * np.sin(shown)
            run = replace(run, channels={**run.channels, found.position: right})
        made.append(run)
    return tuple(made)


def put_even(runs: Sequence[RecordedRun], found: OffAxis) -> tuple[RecordedRun, ...]:
    """Runs whose speed has no ripple that would, summed up, make that wave: its position is right.

    Summed up, ``1 + c sin(q) - s cos(q)`` times a speed is the angle less
    ``c cos(q) + s sin(q)``.
    """
    made = []
    for run in runs:
        if {found.position, found.speed} <= {*run.channels}:
            q, shown = run.channels[found.position], run.channels[found.speed]
            right = shown / (1.0 + found.cosine * np.sin(q) - found.sine * np.cos(q))
            run = replace(run, channels={**run.channels, found.speed: right})
        made.append(run)
    return tuple(made)


def off_axis_remarks(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> list[Finding]:
    """A remark on each such position."""
    return [
        Finding.of_all(
            f"{one.position} differs from {one.speed} summed up by a wave once a turn",
            channels[one.position].written_size(one.size),
            "none: is its encoder off the axis? (a tachometer that ripples would look so too)",
        )
        for one in off_axis(runs, channels)
    ]  # fmt: skip


def _wave(apart: Sequence[np.ndarray], late: float = 0.0) -> tuple[float, float] | None:
    """Cosine and sine of a wave by which positions are off; None where there is none.

    A speed that is `late` leaves beside its lag half the square of that times its rate of change:
    of what swings by its weight that is such a wave, and counts for none.
    """
    # Learned on every second run, and tested on the others.
    learned, tested = np.concatenate(apart[::2]), np.concatenate(apart[1::2])
    whole = float(tested[:, 0] @ tested[:, 0])
    by_wave, by_others = (_left(learned, tested, columns) for columns in (WAVE, OTHERS))
    beside = 0.5 * late**2 * tested[:, CHANGE]
    if by_wave >= min(LEFT * whole, OF_OTHERS * by_others) or beside @ beside > LEFT * whole:
        return None
    every = np.concatenate(apart)
    cosine, sine = np.linalg.lstsq(every[:, WAVE], every[:, 0], rcond=None)[0]
    return float(cosine), float(sine)


def _in_time(apart: Sequence[np.ndarray]) -> tuple[list[np.ndarray], float]:
    """Tables without what goes along with the speed, as a late one makes it; how late it is [s]."""
    every = np.concatenate(apart)
    along = np.linalg.lstsq(every[:, RATE], every, rcond=None)[0]
    return [one - one[:, RATE] * along for one in apart], float(along[0, 0])


def _left(learned: np.ndarray, tested: np.ndarray, columns: slice) -> float:
    """Squares that columns leave of the first one, learned on some rows and tested on others."""
    size = np.linalg.lstsq(learned[:, columns], learned[:, 0], rcond=None)[0]
    return float(np.sum((tested[:, 0] - tested[:, columns] @ size) ** 2))


def _apart(run: RecordedRun, position: str, speed: str) -> np.ndarray:
    """Table (rows, 7) of one run: position less summed speed; cosine and sine; way and its square.

    Then the speed and its rate of change.  Each less a straight line in time, of its own in each
    stretch between gaps: how far it went in one, the speed does not tell.
    """
    shown, rate = run.channels[position], run.channels[speed]
    known = np.isfinite(shown) & np.isfinite(rate)
    time, shown, rate = run.time[known], shown[known], rate[known]
    if time.size <= LEAST:
        return np.zeros((0, 7))
    ends = [0, *(gaps(time) + 1).tolist(), time.size]
    parts = (slice(a, b) for a, b in pairwise(ends))
    return np.concatenate([_between_gaps(time[p], shown[p], rate[p]) for p in parts])


def _between_gaps(time: np.ndarray, shown: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """What `_apart` tells of rows (rows, 7) of which none is missing; none of too few of them.

    The way is that of the speed: at one constant speed a wave in the shown position is all that is
    no straight line in it.
    """
    if time.size <= LEAST:
        return np.zeros((0, 7))
    way = cumulative_trapezoid(rate, time, initial=0.0)
    way += shown.mean() - way.mean()
    change = np.gradient(rate, time)
    told = np.column_stack([shown - way, np.cos(shown), np.sin(shown), way, way**2, rate, change])
    line = np.column_stack([np.ones(time.size), time - time.mean()])
    return beyond(told, line)
