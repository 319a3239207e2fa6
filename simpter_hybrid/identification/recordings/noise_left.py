"""Noise that a filter or a clock shift leaves, from that of what was recorded.

A filtered channel is so smooth that its own differences tell of next to no noise; white noise
through the same filter is known from that of the column.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from .cells import not_logged
from .channel_map import ChannelMap
from .columns import Columns
from .filtering import rate_of
from .map_file import RecordingMap
from .noise import own_noise, stated_noise
from .runs import RunSpan
from .stretches import stretches


def with_noise_left(
    runs: Sequence[RunSpan], columns: Columns, described: RecordingMap
) -> RecordingMap:
    """The map with the noise of what is filtered or shifted, a stated noise being the column's.

    Parameters
    ----------
    runs : sequence of RunSpan
    columns : Columns
    described : RecordingMap
    """
    channels = dict(described.channels)
    for signal, channel in described.channels.items():
        between = bool(channel.clock_shift) and channel.held == "sampled"
        if channel.filter is None and not between:
            continue
        found = [_left(run, columns, described, channel) for run in runs]
        known = [sd for sd in found if sd is not None]
        if known:
            channels[signal] = replace(channel, left=float(np.median(known)))
    return replace(described, channels=channels)


def shaped(channel: ChannelMap, time: np.ndarray, white: np.ndarray) -> np.ndarray:
    """White noise of deviation 1, as the channel's filter makes it, with deviation 1 again."""
    if channel.filter is None:
        return white
    return channel.filter.apply(time, white) / channel.filter.left(time)


def _left(
    run: RunSpan, columns: Columns, described: RecordingMap, channel: ChannelMap
) -> float | None:
    """What is left of one run's noise; None where the sensor was not logged, or says nothing."""
    index, numbers = columns.of_channel(channel, run.rows)
    time, values = described.stamps(columns.numbers, run.rows), channel.to_si(numbers)
    if values.size < 2 or not_logged(channel, values):
        return None
    own = stated_noise(channel)
    own = own_noise(values, channel, time[index]) if own is None else own
    parts = [time[stretch] for stretch in stretches(columns.applies(channel, run.rows))]
    gains = [_gain(channel, part) for part in parts]
    if len(gains) == 1:
        return own * gains[0]
    sizes = [part.size for part in parts]
    return own * float(np.sqrt(np.average(np.square(gains), weights=sizes)))


def _gain(channel: ChannelMap, time: np.ndarray) -> float:
    """Deviation of noise over what it was, of one stretch of rows, which is treated by itself."""
    if time.size < 2:
        return 1.0
    if channel.filter is not None:
        return channel.filter.left(time)
    # A value between two rows is the mean of both.
    part = channel.clock_shift * rate_of(time) % 1.0
    return float(np.hypot(part, 1.0 - part))
