"""What is wrong with a recording: found, named by run, row and time, all at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from ...units import is_unit
from .channel_map import ChannelMap
from .columns import Places
from .jumps import jumps
from .map_file import RecordingMap
from .noise import seen_step
from .row_step import gaps

#: Fewest samples of a run.
FEWEST = 50
#: A measured channel that repeats one value for this long while it moves elsewhere is stuck ...
STUCK_SAMPLES = 200  # unless it is quantised coarser than its noise, or may rest
#: This part of a run's samples at its own extreme value means clipping.
CLIPPED = 0.01
#: Beyond this part of the rows stamps that do not rise are none: intervals, most likely.
OFTEN = 0.25
#: Steps of time are whole numbers of a resolution if they are off one by no more than this.
WHOLE = 1e-3
#: ... and rounded, if so many of the rows share the stamp before.
SHARED = 0.05
#: Part of a constant that is the rounding of its digits.
ROUNDED = 1e-9
#: Part of its largest value below which a speed may be one at rest.
RESTS = 0.05


@dataclass(frozen=True)
class Finding:
    """One thing wrong with one run.

    Parameters
    ----------
    run, what, value, right : str
    row : int
        Counted from 0; -1 if it is of no one row.
    time : float
        [s]
    fatal : bool
        Whether the recording cannot be used as it is.
    """

    run: str
    what: str
    value: str
    right: str
    row: int
    time: float
    fatal: bool = False

    @classmethod
    def of_all(cls, what: str, value: str, right: str) -> Finding:
        """What is wrong with all runs together, at no one row."""
        return cls("all runs", what, value, right, -1, float("nan"))

    def where(self, places: Places) -> str:
        """``file:line (run, t = ...)``; a blank stamp tells no time."""
        at = f", t = {self.time:g} s" if np.isfinite(self.time) else ""
        return f"{places.of(self.row)} ({self.run}{at})"


def check_run(
    name: str,
    row: Callable[[int], int],
    time: np.ndarray,
    channels: Mapping[str, np.ndarray],
    described: RecordingMap,
) -> list[Finding]:
    """Everything wrong with one run whose cells are numbers where numbers are wanted.

    `row`: which one of the file a sample is.
    """

    def at(k: int, what: str, value, right: str, fatal: bool = False) -> Finding:
        when = float(time[k]) if time.size else float("nan")
        return Finding(name, what, f"{value}", right, row(int(k)), when, fatal)

    found = list(_timing(time, at))
    if any(f.fatal for f in found):
        return found
    for signal, values in channels.items():
        channel = described.channels[signal]
        applies = np.ones(time.size, bool) if channel.where is None else np.isfinite(values)
        if channel.role == "measured" and applies.any():
            found += _sensor(signal, values[applies], channel, _among(np.flatnonzero(applies), at))
        if signal.startswith("position") and applies.all():
            found += _jumps(signal, time, values, channel, at)
        if channel.role == "constant" and applies.all():
            found += _changing(signal, values, channel, at)
    return found


def _among(index: np.ndarray, at):
    """As `at`, of samples that are counted among those of `index`."""
    return lambda k, *told: at(index[k], *told)


def _timing(time: np.ndarray, at) -> Iterator[Finding]:
    if time.size < FEWEST:
        right = (
            f"at least {FEWEST}: rows that follow each other faster; or leave the rows of a run "
            "that was broken off out of the file"
        )
        yield at(0, "too few samples in a run", time.size, right, True)
        return
    steps = np.diff(time)
    back = np.flatnonzero(steps <= 0)
    if back.size:
        k = back[0] + 1
        what = "time goes backwards" if steps[k - 1] < 0 else "time stands still"
        right = "rising stamps; where another run begins, a column in [runs] boundaries changes"
        if (steps >= 0.0).all() and (steps > 0.0).any():
            shared = np.mean(steps == 0.0) >= SHARED
            rounded = stamped_to(steps) if shared else 0.0
            finer = f"finer stamps (these are rounded to {rounded:g} s), or " if rounded else ""
            right = f"{finer}one row of each stamp, where rows share one"
        elif back.size > OFTEN * steps.size:
            right += '; of intervals since = "the row before" in the map\'s [time]'
            right += "; or another `column` there"
        yield at(k, f"{what} ({back.size} times)", f"{steps[k - 1]:g} s", right, True)


def stamped_to(steps: np.ndarray) -> float:
    """The decimal just below the least step, if stamps are rounded to it [s]; else 0.0."""
    least = float(steps[steps > 0.0].min())
    decimal = 10.0 ** np.floor(np.log10(least) + WHOLE)
    parts = steps / decimal
    whole = np.abs(parts - np.rint(parts)) < WHOLE
    return float(decimal) if whole.all() else 0.0


def gap_remarks(
    name: str, row: Callable[[int], int], time: np.ndarray, parted: str = ""
) -> Iterator[Finding]:
    """Where rows are missing in a run, if they are; of stamps that were put right.

    `row`: which one of the file a sample is.  `parted`: what in the map would make runs of their
    own of what is between them, if known.
    """
    found, steps = gaps(time), np.diff(time)
    if found.size:
        k = int(found[np.argmax(steps[found])])
        what = "a gap" if found.size == 1 else f"{found.size} gaps, the longest here"
        right = (
            f"steps of about {np.median(steps):g} s; behind it another replay begins, unless "
            "gaps leave too little between them"
        )
        right += f"; {parted} begins another run there" if parted else ""
        yield Finding(name, what, f"{steps[k]:.3g} s", right, row(k), float(time[k]))


def _sensor(signal: str, values: np.ndarray, channel: ChannelMap, at) -> Iterator[Finding]:
    span = float(values.max() - values.min())
    if channel.may_rest and channel.limits is None:
        yield from _stuck_on_its_way(signal, values, channel, at)
        return
    if span == 0.0:
        yield at(0, f"{signal} never changes", channel.written(values[0]), "a live sensor")
        return
    if channel.limits is None:
        yield from _clipped(signal, values, channel, at)
    start, length = _longest_repeat(values)
    quiet = channel.step is not None and (channel.noise or 0.0) < channel.step
    if length >= STUCK_SAMPLES and not quiet and not channel.may_rest:
        what = f"{signal} repeats one value for {length} samples"
        right = "a sensor with noise, or its step in the map"
        yield at(start, what, channel.written(values[start]), right)


def _stuck_on_its_way(
    signal: str, values: np.ndarray, channel: ChannelMap, at
) -> Iterator[Finding]:
    """Remark on a speed that stays exactly at one value other than zero for long.

    The map says that it may rest, but a speed rests at zero: here the sensor is stuck.
    """
    if not signal.startswith("speed") or (channel.step or seen_step(values)) is not None:
        return
    moving = np.abs(values) > RESTS * np.abs(values).max()
    start, length = _longest_repeat(np.where(moving, values, np.nan))
    if length >= STUCK_SAMPLES:
        what = f"{signal} repeats one value for {length} samples, while it moves"
        right = "a sensor with noise; `may_rest` in the map speaks of rest, its step of coarseness"
        yield at(start, what, channel.written(values[start]), right)


def _jumps(
    signal: str, time: np.ndarray, values: np.ndarray, channel: ChannelMap, at
) -> Iterator[Finding]:
    found = jumps(time, values)
    if found.size:
        k = int(found[0])
        what = f"{signal} jumps from one sample to the next ({found.size} times, first here)"
        right = "no outliers: leave their rows out (where another run begins, say so by [runs])"
        if is_unit(channel.unit, "angle"):
            again = 'unwrapped: wraps = "360 deg" in the map, if it begins anew there'
            again = "unwrapped by another `wraps`" if channel.wraps else again
            right = f"an angle that goes on beyond a turn ({again}), and {right}"
        yield at(k, what, channel.written_change(values[k] - values[k - 1]), right, True)


def _changing(signal: str, values: np.ndarray, channel: ChannelMap, at) -> Iterator[Finding]:
    """Remark on a channel that the map calls constant and that changes within the run."""
    other = np.flatnonzero(~np.isclose(values, values[0], rtol=ROUNDED, atol=0.0))
    if other.size:
        what = f"{signal} changes within a run, which the map calls constant"
        right = f'{channel.written(values[0])}, by which runs are told apart, or role = "input"'
        yield at(other[0], what, channel.written(values[other[0]]), right)


def _clipped(signal: str, values: np.ndarray, channel: ChannelMap, at) -> Iterator[Finding]:
    """An extreme that is held: many samples at exactly the largest value, and beside it none."""
    for extreme, side in ((values.max(), "largest"), (values.min(), "smallest")):
        here = np.flatnonzero(values == extreme)
        together = (np.diff(here) == 1).sum() > 0.8 * (here.size - 1)
        if here.size > max(CLIPPED * values.size, 20) and together:
            near = np.abs(values - extreme) <= (channel.step or 0.0) + 1e-12
            rest = np.abs(np.diff(values[near])).sum()
            if rest == 0.0 and extreme not in (0.0, values[0]):
                what = f"{signal} stays at its {side} value for {here.size} samples: clipped?"
                yield at(here[0], what, channel.written(extreme), "limits of the sensor in the map")


def stays(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where each value begins that is followed by another, and for how many samples it stays."""
    edges = np.flatnonzero(np.diff(values) != 0.0) + 1
    starts = np.concatenate([[0], edges]).astype(int)
    return starts, np.diff(np.concatenate([starts, [values.size]]))


def _longest_repeat(values: np.ndarray) -> tuple[int, int]:
    """Start and length of the longest stretch of one value."""
    starts, lengths = stays(values)
    k = int(np.argmax(lengths))
    return int(starts[k]), int(lengths[k])
