"""Positions that are logged whenever a mark passes: a magnet, a slot, a light gate.

Every row is one step on, and nothing is rounded to it: what is uncertain is when the mark passed.
So the noise of such a position is that of its stamps, times the speed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .map_file import RecordingMap
from .noise import noise_estimate
from .recorded_run import RecordedRun

#: Part of the rows that may be several steps on (a mark was missed); part of a step by which steps
#: differ at most.
FEW, EQUAL = 0.1, 1e-6
#: Stamps whose steps scatter by less than this part of their mean are those of a clock.
STEADY = 0.02
#: Rows that tell.
FEWEST = 10


def with_noise_of_stamps(
    runs: Sequence[RecordedRun], described: RecordingMap
) -> tuple[RecordingMap, list[Finding]]:
    """The map with the noise of positions that are logged at marks, and a remark on each.

    Where the map states the noise, that is it.
    """
    channels, told = dict(described.channels), []
    for name, channel in described.channels.items():
        if not _asked(name, channel):
            continue
        known = [_at_marks(run.time, run.channels[name]) for run in runs if name in run.channels]
        if not known or None in known:
            continue
        noise = float(np.median([one for one in known if one is not None]))
        channels[name] = replace(channel, left=max(noise, 1e-12), step=None)
        size = channel.written_size(noise)
        what = f"{name} goes on by one step a row, at stamps that differ"
        right = "taken as marks whose stamps are uncertain; else state its `noise`"
        told.append(Finding.of_all(what, f"a noise of {size}", right))
    return replace(described, channels=channels), told


def _asked(name: str, channel: ChannelMap) -> bool:
    moved = channel.filter is not None or channel.clock_shift != 0.0
    return (
        name.startswith("position")
        and channel.role == "measured"
        and channel.noise is None
        and not moved
    )


def _at_marks(time: np.ndarray, values: np.ndarray) -> float | None:
    """Noise [SI] of one run's position if its rows are marks; None if they are not."""
    if values.size < FEWEST or not np.isfinite(values).all():
        return None
    rises, steps = np.diff(values), np.diff(time)
    usual = float(np.median(rises))
    if usual == 0.0 or np.std(steps) < STEADY * np.mean(steps):
        return None
    count = np.round(rises / usual)
    whole = (np.abs(rises / usual - count) <= EQUAL) & (count >= 1.0)
    if not whole.all() or np.mean(count == 1.0) < 1.0 - FEW:
        return None
    return noise_estimate(time) * abs(usual) / float(np.median(steps))
