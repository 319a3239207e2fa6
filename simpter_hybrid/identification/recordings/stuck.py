"""What sensors saw that stays at exactly one value, and repeats none elsewhere."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .channel_map import ChannelMap
from .checks import FEWEST, STUCK_SAMPLES, Finding, stays
from .columns import Columns
from .map_file import RecordingMap
from .map_units import PLAIN
from .row_step import parted
from .runs import RunSpan

#: Part of the rows elsewhere that may repeat the one before: decimals do that now and then.
SELDOM = 0.1
#: What stays at so many values for this part of a run is set, not stuck (speeds on stairs).
SET_LEVELS, STAYS = 3, 0.9
#: A position goes on with a jump if that is so many times as far as each of so many rows behind it,
#: and as its smallest step.
JUMPS, BESIDE = 5.0, 5
#: What sensors saw, by how its name begins; what is told or set stays where it likes.
SENSED = ("force", "torque", "current", "pressure", "speed", "temperature")


def stuck_inputs(run: RunSpan, columns: Columns, described: RecordingMap) -> Iterator[Finding]:
    """Remarks on one run, in the numbers of its columns.

    Parameters
    ----------
    run : RunSpan
    columns : Columns
    described : RecordingMap
    """
    time = described.stamps(columns.numbers, run.rows)
    for signal, channel in described.channels.items():
        if not seen_by_a_sensor(signal, channel):
            continue
        index, numbers = columns.of_channel(channel, run.rows)
        if not numbers.size:
            continue
        starts, lasts = stays(numbers)
        if lasts.max() < STUCK_SAMPLES:
            continue
        if _is_set(numbers[starts[lasts >= STUCK_SAMPLES]], lasts):
            continue
        rest, repeats = _elsewhere(lasts)
        if rest < FEWEST and not numbers.any():  # not driven in this run
            continue
        if rest < FEWEST:  # then what it does in other runs tells
            every = columns.of_channel(channel, (0, columns.size))[1]
            rest, repeats = _elsewhere(stays(every)[1])
        if rest < FEWEST or repeats > SELDOM * rest:
            continue
        k = int(starts[np.argmax(lasts)])
        what = f"{signal} repeats one value for {lasts.max()} samples, and hardly any elsewhere"
        right = "a live sensor; or `held` in the map, if it is set and holds"
        value = channel.written(float(channel.to_si(numbers)[k]))
        row, stamp = run.rows[0] + int(index[k]), float(time[index[k]])
        yield Finding(run.name, what, value, right, row, stamp)


def stuck_positions(run: RunSpan, columns: Columns, described: RecordingMap) -> Iterator[Finding]:
    """Remarks on positions that may rest, but jump where they go on: what rests begins slowly.

    Parameters
    ----------
    run : RunSpan
    columns : Columns
    described : RecordingMap
    """
    time = described.stamps(columns.numbers, run.rows)
    for signal, channel in described.channels.items():
        if not (signal.startswith("position") and channel.may_rest):
            continue
        index, numbers = columns.of_channel(channel, run.rows)
        if numbers.size < FEWEST:
            continue
        own = time[index]
        starts, lasts = stays(numbers)
        rest, repeats = _elsewhere(lasts)
        # Over a pause it may go far.
        steps = np.nan_to_num(np.where(parted(own), 0.0, np.abs(np.diff(numbers))))
        moved = steps[steps > 0.0]
        if rest < FEWEST or repeats > SELDOM * rest or not moved.size:
            continue
        for start, length in zip(starts.tolist(), lasts.tolist(), strict=True):
            after = steps[start + length : start + length + BESIDE]
            if length < STUCK_SAMPLES or not after.size:
                continue
            jump = float(steps[start + length - 1])
            goes_on = float(after.max())  # what sticks and snaps rests again
            if goes_on > 0.0 and jump > JUMPS * max(goes_on, float(moved.min())):
                what = f"{signal} repeats one value for {length} samples, and jumps behind them"
                right = "a live sensor; if it did move meanwhile, leave these rows out"
                value = channel.written(float(channel.to_si(numbers)[start]))
                row = run.rows[0] + int(index[start])
                yield Finding(run.name, what, value, right, row, float(own[start]))


def _is_set(levels: np.ndarray, lasts: np.ndarray) -> bool:
    """Whether something was set to several levels in turn, and hardly moved between them."""
    most = int(lasts[lasts >= STUCK_SAMPLES].sum()) > STAYS * int(lasts.sum())
    return most and np.unique(levels).size >= SET_LEVELS


def _elsewhere(lasts: np.ndarray) -> tuple[int, int]:
    """Rows outside of long stays, and how many of them repeat the one before."""
    short = lasts[lasts < STUCK_SAMPLES]
    return int(short.sum()), int(short.sum()) - short.size


def seen_by_a_sensor(signal: str, channel: ChannelMap) -> bool:
    """Whether an input is what a sensor saw, and not what was set."""
    told = channel.held != "sampled" or channel.may_rest or channel.unit in PLAIN
    return channel.role == "input" and signal.startswith(SENSED) and not told
