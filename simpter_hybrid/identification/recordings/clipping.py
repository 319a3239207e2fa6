"""What was cut off: a force, drive or position that stays at exactly its extreme, several times."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
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


class _Stretches(NamedTuple):
    """Samples of one value, one after another, run by run; each entry an array."""

    run: np.ndarray
    first: np.ndarray
    size: np.ndarray
    value: np.ndarray

    @property
    def steps(self) -> np.ndarray:
        """How far it is to the next one; none, NaN, to another run."""
        far = np.abs(np.diff(self.value))
        return np.where(np.diff(self.run) == 0, far, np.nan)


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
        stretches = _stretches(runs, name)
        if not stretches.value.size:
            continue
        for extreme, side in (
            (stretches.value.max(), "largest"),
            (stretches.value.min(), "smallest"),
        ):
            full = extreme == 0.0 or (channel.unit in ("", "1") and extreme in FULL)
            if full or not channel.within(channel.number(extreme)):
                continue
            if (cut := _stays(stretches, extreme)).any():
                yield _finding(name, side, channel, runs, stretches, cut)


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


def _stretches(runs: Sequence[RecordedRun], name: str) -> _Stretches:
    parts = [np.empty((4, 0))]
    for k, run in enumerate(runs):
        if name not in run.channels:
            continue
        values = run.channels[name]
        starts, lasts = stays(values)
        part = np.array([np.full(starts.size, k), starts, lasts, values[starts]], float)
        parts.append(part[:, np.isfinite(part[3])])
    run, first, size, value = np.concatenate(parts, axis=1)
    return _Stretches(run.astype(int), first.astype(int), size.astype(int), value)


def _stays(stretches: _Stretches, extreme: float) -> np.ndarray:
    """Which stretches at an extreme show that it is a limit; none if it may be any value."""
    there = (stretches.value == extreme) & (stretches.size >= SAMPLES)
    # The other end may be cut off as well; a rest at 0 is no end of what is pushed one way.
    value = stretches.value
    between = (value > value.min()) & (value < value.max())
    others = stretches.size[between | (np.abs(value) < abs(extreme))]
    steps = stretches.steps
    if there.any() and others.size and not np.isnan(steps).all():
        # What is cut off comes to its limit as it changes elsewhere; what is set jumps there.
        usual = steps <= np.nanquantile(steps, ELSEWHERE)
        there &= np.append(usual, False) | np.append(False, usual)
        if _times(stretches, extreme, there) >= TIMES:
            long = LONGER * float(np.quantile(others, ELSEWHERE))
            if float(np.median(stretches.size[there])) > long:
                return there
    return np.zeros_like(there)


def _times(stretches: _Stretches, extreme: float, stays: np.ndarray) -> int:
    """How often a channel came to stay: what flickers by one step of its sensor has not left."""
    steps = stretches.steps[stretches.steps > 0.0]
    near = FLICKERS * float(steps.min()) if steps.size else 0.0
    left = np.cumsum(np.abs(stretches.value - extreme) > near)[stays]
    again = (np.diff(left) > 0) | (np.diff(stretches.run[stays]) != 0)
    return int(stays.any()) + int(np.count_nonzero(again))


def _finding(
    name: str, side: str, channel: ChannelMap, runs: Sequence[RecordedRun],
    stretches: _Stretches, cut: np.ndarray,
) -> Finding:  # fmt: skip
    k = int(np.argmax(cut))
    run, first = runs[stretches.run[k]], int(stretches.first[k])
    what = f"{name} stays at its {side} value {np.count_nonzero(cut)} times, "
    what += f"{stretches.size[cut].sum()} samples in all, the first here: cut off?"
    right = "a sensor whose range is not left; or `limits` in the map, if it can be no more"
    got = channel.written(float(stretches.value[k]))
    return Finding(run.name, what, got, right, run.row(first), float(run.time[first]))
