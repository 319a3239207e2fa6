"""Channels of which the map has a step, or a noise, that its values deny."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .noise import own_noise

if TYPE_CHECKING:  # runs are checked while a recording is made of them
    from .recorded_run import RecordedRun

#: Values that differ by less than this part of a step are not rounded to it ...
FINER = 0.4
#: ... if so many of those that differ at all do: decimals make some steps unequal.
OFTEN = 0.2
#: A noise that is stated this many times as large as what rows differ by would hide a lack.
QUIETER = 5.0
#: Quantile of the differences between rows that is told as the smallest one.
LEAST = 0.02


def finer_than_told(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> Iterator[Finding]:
    """Remarks on channels with values nearer to one another than the `step` that the map states.

    Parameters
    ----------
    runs : sequence of RecordedRun
    channels : mapping of str to ChannelMap
        What was filtered or shifted in time is rounded to nothing.
    """
    for name, channel in channels.items():
        if channel.step is None or channel.filter is not None or channel.clock_shift != 0.0:
            continue
        seen = [run.channels[name][run.compared(name)] for run in runs if name in run.channels]
        rises = [np.abs(np.diff(values)) for values in seen]
        every = np.concatenate([r[np.isfinite(r) & (r > 0.0)] for r in rises] or [np.zeros(0)])
        if not every.size or np.mean(every < FINER * channel.step) < OFTEN:
            continue
        usual = channel.written_size(float(np.quantile(every, LEAST)))
        told = channel.written_size(channel.step)
        what = f"{name} has values nearer to one another than the `step` of its map"
        right = f"values {told} apart; is the step, or the unit, right?"
        yield Finding.of_all(what, usual, right)


def quieter_than_told(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> Iterator[Finding]:
    """Remarks on channels whose rows differ by far less than the `noise` that the map states.

    Slow errors of a sensor do not show from row to row, so this is asked and not refused.

    Parameters
    ----------
    runs : sequence of RecordedRun
    channels : mapping of str to ChannelMap
    """
    for name, channel in channels.items():
        if channel.noise is None or channel.role != "measured" or channel.filter is not None:
            continue
        seen = [(run.channels[name], run.time) for run in runs if name in run.channels]
        moving = [(v, t) for v, t in seen if np.unique(v[np.isfinite(v)]).size > 1]
        if not moving:
            continue
        usual = float(np.median([own_noise(values, channel, time) for values, time in moving]))
        if channel.noise <= QUIETER * usual:
            continue
        what = f"{name} differs from row to row by far less than the `noise` of its map"
        told = channel.written_size(channel.noise)
        right = (
            f"about {told}; a lack of that size would be hidden: is it slow errors, or too large?"
        )
        got = channel.written_size(usual)
        yield Finding.of_all(what, got, right)
