"""The speed at which an axis that is let alone comes to rest: another than zero is the sensor's."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .noise import run_noise
from .recorded_run import RecordedRun
from .runs import name_of_whole

#: Last rows that tell a level, at the least; rows belong to the rest as long as they are within so
#: many deviations of it.
FEWEST, WITHIN = 20, 4.0
#: The level is so many deviations of the noise, and at most this part of the largest speed.
SURE, SMALL = 3.0, 0.1
#: In as much time before the rest the speed fell by so many times the level ...
FELL = 1.5
#: ... and in the rest by less than this part of it, by two standard errors more.  A drag that goes
#: with speed, or with its square, would still take 0.6 or 0.37 away.
RESTS = 0.3
#: Remark on such a level.
LEVEL = "comes to rest, and not at zero"


def rest_remarks(
    runs: Sequence[RecordedRun], channel: ChannelMap, signal: str
) -> tuple[Finding, ...]:
    """Remarks on runs of which a speed rests at another value than zero.

    Parameters
    ----------
    runs : sequence of RecordedRun
        Nothing drives them; pieces of one run are asked together.
    channel : ChannelMap
    signal : str
        The speed.
    """
    whole: dict[str, list[RecordedRun]] = {}
    for run in runs:
        if signal in run.channels and signal.startswith("speed"):
            whole.setdefault(name_of_whole(run), []).append(run)
    found = []
    for pieces in whole.values():
        time = np.concatenate([run.time for run in pieces])
        speed = np.concatenate([run.channels[signal] for run in pieces])
        rows, level = resting(time, speed, run_noise(speed, channel, time))
        if rows:
            last = pieces[-1]
            lasts = float(time[-1] - time[-rows])
            right = (
                f"0 for its last {lasts:.3g} s: if it stands still, the sensor's zero is off; "
                f'add "{channel.written_change(-level)}" to its `offset` in the map'
            )
            where = last.rows[1] - 1, float(time[-1])
            found.append(Finding(last.name, LEVEL, channel.written_size(level), right, *where))
    return tuple(found)


def resting(time: np.ndarray, speed: np.ndarray, noise: float) -> tuple[int, float]:
    """Number of last rows in which a speed rests at a level that is not zero, and that level.

    0 rows if it does not: if it rests at zero, or slows still.
    """
    if speed.size < 3 * FEWEST or not np.isfinite(speed).all():
        return 0, 0.0
    level = float(np.median(speed[-FEWEST:]))
    off = np.flatnonzero(np.abs(speed - level) > WITHIN * noise)
    rows = speed.size - 1 - int(off[-1]) if off.size else 0
    if rows < FEWEST or 2 * rows > speed.size:
        return 0, 0.0
    rest, before = slice(-rows, None), slice(-2 * rows, -rows)
    level = float(np.mean(speed[rest]))
    small = abs(level) < SMALL * float(np.abs(speed).max())
    lasts = float(time[-1] - time[-rows])
    above = np.sign(np.mean(speed[before]) - level)
    fell = -_slope(time[before], speed[before]) * lasts * above
    unsure = 2.0 * noise * np.sqrt(12.0 / rows)
    falls = abs(_slope(time[rest], speed[rest])) * lasts + unsure
    sure = small and abs(level) > SURE * noise
    return (rows, level) if sure and fell > FELL * abs(level) > FELL / RESTS * falls else (0, 0.0)


def _slope(time: np.ndarray, course: np.ndarray) -> float:
    return float(np.polyfit(time - time[0], course, 1)[0])
