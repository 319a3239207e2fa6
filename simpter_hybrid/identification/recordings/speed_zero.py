"""A measured speed that is off by the same in all runs: its sensor's zero, by the position beside.

A gain is off by more where it moves faster, and a late speed where it changes: beside these what is
off by the same all the time is told wherever speeds differ.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from .agreement import FEW, GAIN, SPAN, TELLING, Runs, beside, ends_of_movements, movements
from .channel_map import ChannelMap
from .checks import Finding
from .projection import beyond

#: Part of the time's mean square that speeds leave of it: where all are one speed a zero is a gain.
TOLD = 0.2
#: A zero is so many times what a speed over a tenth of a second is off by at random ...
FAR = 3.0
#: ... and that of no run differs from it by more than this part.
ALIKE = 0.5
#: How the remark ends, by which it is known.
IN_ALL = "by the same in every run"


class SpeedZero(NamedTuple):
    """A speed that shows ``zero`` [SI] more than its position's rate."""

    speed: str
    position: str
    zero: float


class _Apart(NamedTuple):
    """Of a run: how far its movements are off, and what goes along with that (movements,)."""

    off: np.ndarray
    beside: np.ndarray
    lasts: np.ndarray


def speed_zeros(runs: Runs, channels: Mapping[str, ChannelMap]) -> Iterator[SpeedZero]:
    """Measured speeds with another zero; none of a speed that is off otherwise in some run.

    Parameters
    ----------
    runs : sequence of (ndarray (samples,), mapping of str to ndarray (samples,))
        Time stamps [s], and signal -> values [SI].
    channels : mapping of str to ChannelMap
    """
    for speed, position, _ in beside(runs, channels):
        if {channels[speed].role, channels[position].role} != {"measured"}:
            continue
        made = [_apart(*run, position, speed) for run in runs if {position, speed} <= {*run[1]}]
        long = [run for run in made if run.off.size >= TELLING]
        if len(long) >= FEW and (zero := _zero(long)) is not None:
            yield SpeedZero(speed, position, zero)


def less_zeros(runs: Runs, found: Sequence[SpeedZero]) -> Runs:
    """Runs whose speeds have these zeros no longer."""
    off = {one.speed: one.zero for one in found}
    return [(time, {n: v - off.get(n, 0.0) for n, v in seen.items()}) for time, seen in runs]


def zero_remarks(
    found: Sequence[SpeedZero], channels: Mapping[str, ChannelMap]
) -> list[Finding]:  # fmt: skip
    """A remark on each, with what to write in the map: before the sign, with what stands there."""
    told = []
    for one in found:
        channel = channels[one.speed]
        scale, unit = channel.unit_scale, channel.suffix
        offset = f"{(channel.shift - channel.sign * one.zero) / scale:.3g}{unit}"
        what = f"{one.speed} differs from the rate of {one.position} {IN_ALL}"
        value = f"{one.zero / scale:.3g}{unit}"
        right = f'none: is the zero of its sensor off? (`offset = "{offset}"` in the map)'
        told.append(Finding.of_all(what, value, right))
    return told


def _zero(runs: Sequence[_Apart]) -> float | None:
    """The zero of all runs [SI]; None where there is none, or where it is not told."""
    off, along, lasts = (np.concatenate(part) for part in zip(*runs, strict=True))
    alone = beyond(lasts, along)
    if float(alone @ alone) < TOLD * float(lasts @ lasts):
        return None
    factors = np.linalg.lstsq(np.column_stack([along, lasts]), off, rcond=None)[0][:-1]
    left = [(run.off - run.beside @ factors, run.lasts) for run in runs]
    zero = float(np.median([rest.sum() / time.sum() for rest, time in left]))
    scatter = [np.std(rest / time) for rest, time in left]
    usual = [np.sqrt(np.mean((run.beside[:, 0] / run.lasts) ** 2)) for run in runs]
    least = max(FAR * float(np.median(scatter)), GAIN * float(np.median(usual)))
    # Of few runs zeros of their own may go along with their speeds, as a gain makes them.
    as_seen = ((run.off, run.lasts) for run in runs)
    alike = _alike(as_seen) and _alike(left)
    return zero if abs(zero) > least and alike else None


def _alike(runs: Iterable[tuple[np.ndarray, np.ndarray]]) -> bool:
    """Whether what is off, over the time that it takes, is about the same in each run."""
    each = np.array([off.sum() / time.sum() for off, time in runs])
    usual = float(np.median(each))
    return bool((np.abs(each - usual) <= ALIKE * abs(usual)).all())


def _apart(
    time: np.ndarray, found: Mapping[str, np.ndarray], position: str, speed: str
) -> _Apart:  # fmt: skip
    """What a run's speed, summed up over a tenth of a second each, has more than its position."""
    moved, expected, gained = movements(time, found[position], found[speed], SPAN)
    known = time[np.isfinite(found[position]) & np.isfinite(found[speed])]
    ends = ends_of_movements(known, SPAN) if known.size > 1 else [np.zeros(0, int)]
    lasts = np.concatenate([np.diff(known[at]) for at in ends])
    return _Apart(expected - moved, np.column_stack([expected, gained]), lasts)
