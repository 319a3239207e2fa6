"""What was cut off: a force, drive or position that stays at exactly its extreme, several times."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding, stays

if TYPE_CHECKING:  # runs are checked while a recording is made of them
    from .recorded_run import RecordedRun

#: So many stays of at least so many samples: once may be a stop, and two samples may be equal.
TIMES, SAMPLES = 3, 5
#: They last so many times as long as one value does elsewhere: a coarse step makes the top of any
#: wave flat, 2.4 times as long as the step below; a command that is set in steps stays everywhere.
LONGER, ELSEWHERE = 5.0, 0.98
#: A reading that leaves its extreme by less than so many of its steps flickers there.
FLICKERS = 1.5
#: What is set on purpose, and what may rest, stays where it likes.
SET = ("command", "neighbour_command", "reference", "position", "speed")
#: What a sensor saw, though a row holds until the next, by its name: no rig is known here yet.
SENSED = ("force", "torque", "pressure")
#: Nothing, and all, of what is given in plain numbers (a duty).
FULL = (0.0, 1.0, -1.0)


class _Stretch(NamedTuple):
    """Samples of one value in one run."""

    run: RecordedRun
    first: int
    size: int
    value: float


def clipped_inputs(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> Iterator[Finding]:
    """Remarks on channels that look cut off; limits that the map states are known.

    Parameters
    ----------
    runs : sequence of RecordedRun
    channels : mapping of str to ChannelMap
    """
    for name, channel in channels.items():
        if not _may_be_cut_off(name, channel):
            continue
        stretches = [s for run in runs if name in run.channels for s in _stretches(run, name)]
        if not stretches:
            continue
        values = [s.value for s in stretches]
        for extreme, side in ((max(values), "largest"), (min(values), "smallest")):
            full = extreme == 0.0 or (channel.unit in ("", "1") and extreme in FULL)
            if full or not channel.within(channel.number(extreme)):
                continue
            if cut := _stays(stretches, extreme):
                yield _finding(name, side, channel, cut)


def _may_be_cut_off(name: str, channel: ChannelMap) -> bool:
    """Whether a channel's stays at its extremes would mean that it was cut off.

    That is so for an input that a sensor or a driver gave, and for a position that may rest, of
    which nothing else is remarked.  Of other measured channels a value that repeats is remarked
    anyway.
    """
    if channel.role == "measured":
        return name.startswith("position") and channel.may_rest and channel.limits is None
    told = channel.held != "sampled" and not name.startswith(SENSED)
    return channel.role == "input" and not told and not name.startswith(SET)


def _stretches(run: RecordedRun, name: str) -> list[_Stretch]:
    values = run.channels[name]
    starts, lasts = stays(values)
    return [
        _Stretch(run, int(a), int(last), float(values[a]))
        for a, last in zip(starts, lasts, strict=True)
        if np.isfinite(values[a])
    ]


def _stays(stretches: Sequence[_Stretch], extreme: float) -> list[_Stretch]:
    """Stretches at an extreme that show it is a limit; none if it may be a value like others."""
    others = [s.size for s in stretches if abs(s.value) < abs(extreme)]
    beside = [(a, b) for a, b in pairwise(stretches) if a.run is b.run]
    if not others or not beside:
        return []
    usual = float(np.quantile([abs(b.value - a.value) for a, b in beside], ELSEWHERE))
    # What is cut off comes to its limit as it changes elsewhere; a pulse that is set jumps there.
    reached = {id(s) for a, b in beside if abs(b.value - a.value) <= usual for s in (a, b)}
    there = [s for s in stretches if s.value == extreme and s.size >= SAMPLES and id(s) in reached]
    long = LONGER * float(np.quantile(others, ELSEWHERE))
    enough = (
        _times(stretches, extreme, there) >= TIMES
        and float(np.median([s.size for s in there])) > long
    )
    return there if enough else []


def _times(stretches: Sequence[_Stretch], extreme: float, stays: Sequence[_Stretch]) -> int:
    """How often a channel came to stay: what flickers by one step of its sensor has not left."""
    steps = [abs(b.value - a.value) for a, b in pairwise(stretches) if a.run is b.run]
    near = FLICKERS * min((step for step in steps if step > 0.0), default=0.0)
    at, times, left, run = {id(s) for s in stays}, 0, True, None
    for s in stretches:
        if s.run is not run or abs(s.value - extreme) > near:
            run, left = s.run, True
        if id(s) in at and left:
            times, left = times + 1, False
    return times


def _finding(name: str, side: str, channel: ChannelMap, stays: Sequence[_Stretch]) -> Finding:
    first = stays[0]
    what = f"{name} stays at its {side} value {len(stays)} times, "
    what += f"{sum(s.size for s in stays)} samples in all, the first here: cut off?"
    right = "a sensor whose range is not left; or `limits` in the map, if it can be no more"
    row, stamp = first.run.rows[0] + first.first, float(first.run.time[first.first])
    return Finding(first.run.name, what, channel.written(first.value), right, row, stamp)
