"""Does what is left swing at one frequency?

So do an elastic rod, belt or mount, a loop that rings, and mains.  No curve over a coordinate shows
it; in a spectrum it stands out of what lies around it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from ..fitting.repeats import left_of
from ..fitting.replay import Replay
from ..recordings.row_step import row_step

#: Length of a stretch whose spectrum is taken [s], and the fewest stretches of a run.
STRETCH, FEWEST = 1.0, 4
#: A sine is this many bins wide either way (Hann), so no line is slower than some bins ...
WIDE, SLOWEST = 2, 4
#: ... nor is one looked for that is faster than this [Hz].
FASTEST = 250.0
#: Frequencies within the first factor of a line belong to it; it is compared with those within the
#: second.
NEAR, AROUND = 1.12, 1.6
#: A line has so many times the power of what lies around it (of 30 runs of four real rigs two had
#: 27 and 41 times, the others up to 7), and this part of the mean square.
STANDS_OUT, PART = 10.0, 0.05
#: Speeds that vary by less than this part of their mean are one; what a motion repeats is looked
#: for at up to so many times its frequency.
ONE_SPEED, MULTIPLES = 0.3, 9
#: Lines of two runs are the same up to this part of their frequency.
SAME = 0.05


class Line(NamedTuple):
    """Frequency [Hz], part of the mean square that is near it, and times what lies around it."""

    frequency: float
    part: float
    over: float


def strongest(series: np.ndarray, step: float) -> Line | None:
    """The line that stands out most of a course (samples,); None of one that is too short.

    Parameters
    ----------
    series : ndarray (samples,)
        NaN in rows that say nothing.
    step : float
        Sample interval [s].
    """
    from scipy.signal import welch

    known = np.where(np.isfinite(series), series, 0.0)
    size = round(STRETCH / step) if step > 0.0 else 0
    if size < 4 * SLOWEST or known.size < FEWEST * size or not known.any():
        return None
    frequency, power = welch(known, 1.0 / step, nperseg=size)
    bins = np.arange(frequency.size)
    best: Line | None = None
    for k in bins[SLOWEST : np.searchsorted(frequency, FASTEST)]:
        low, high = min(k / NEAR, k - WIDE), max(k * NEAR, k + WIDE)
        near = slice(int(np.ceil(low)), int(high) + 1)
        if power[k] < power[near].max():
            continue  # the flank of another
        wide = slice(
            max(1, int(min(k / AROUND, low - WIDE))), int(max(k * AROUND, high + WIDE)) + 1
        )
        around = np.concatenate([power[wide.start : near.start], power[near.stop : wide.stop]])
        usual = float(np.median(around)) if around.size else np.inf
        over = float(power[k]) / usual if usual > 0.0 else np.inf
        if best is None or over > best.over:
            above = float((power[near] - min(usual, power[k])).sum() * frequency[1])
            best = Line(float(frequency[k]), max(above, 0.0) / float(np.mean(known**2)), over)
    return best


def lines_of(
    replays: Sequence[Replay], predicted: Mapping[str, Sequence[np.ndarray]]
) -> dict[str, Line]:
    """Run -> its strongest line of any channel; runs without one are left out."""
    found: dict[str, Line] = {}
    for i, replay in enumerate(replays):
        step = row_step(replay.time) if replay.time.size > 1 else 0.0
        for channel in replay.observed:
            one = strongest(left_of(replay, channel, predicted[channel][i]), step)
            if one is None or one.over < STANDS_OUT or one.part < PART:
                continue
            if replay.name not in found or one.over > found[replay.name].over:
                found[replay.name] = one
    return found


def of_the_motion(frequency: float, speed: np.ndarray, step: float) -> bool:
    """Whether what swings at a frequency [Hz] may come of the motion itself.

    A motion that repeats itself does all that friction does at multiples of its frequency, and one
    of a single speed passes a wave along the way at one frequency.

    Parameters
    ----------
    frequency : float
    speed : ndarray (samples,)
        Of the motion.
    step : float
        Sample interval [s].
    """
    rate = np.abs(speed[np.isfinite(speed)])
    if rate.size < 2 or float(np.std(rate)) < ONE_SPEED * float(np.mean(rate)):
        return True
    known = np.nan_to_num(speed)
    power = np.abs(np.fft.rfft((known - known.mean()) * np.hanning(known.size))) ** 2
    usual = float(np.argmax(power)) / (known.size * step)
    times = frequency / usual if usual > 0.0 else 0.0
    return round(times) <= MULTIPLES and abs(times - round(times)) < SAME * max(times, 1.0)


def same_line(lines: Mapping[str, Line]) -> tuple[str, ...]:
    """The most runs whose lines are the same; none if no two are."""
    alike = [
        tuple(
            run for run, other in lines.items() if abs(other.frequency / one.frequency - 1) < SAME
        )
        for one in lines.values()
    ]
    most = max(alike, key=len, default=())
    return most if len(most) > 1 else ()
