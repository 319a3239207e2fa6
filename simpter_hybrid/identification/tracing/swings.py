"""Does what is left swing at one frequency, whatever the motion does?

So do an elastic rod, belt or mount, a loop that rings, and mains.  No curve over a coordinate shows
it; in a spectrum it stands out of what lies around it.  What comes again with the place has
another frequency at every speed, and no line in a run that goes at several.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from ..fitting.repeats import left_of
from ..fitting.replay import Replay

#: Length of a stretch whose spectrum is taken [s], and the fewest stretches of a run.
STRETCH, FEWEST = 1.0, 4
#: Lines of the spectrum left out: what is slower than some swings in a stretch is no line.
SLOW = 3
#: Around a line: what counts as it, and what it is compared with (times its frequency either way).
NEAR, AROUND = 1.12, 1.6
#: A line has so many times the power of what lies around it (of 30 runs of four real rigs two had
#: 27 and 41 times, the others up to 7), and this part of the mean square.
STANDS_OUT, PART = 10.0, 0.05
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

    size = round(STRETCH / step)
    known = np.where(np.isfinite(series), series, 0.0)
    if known.size < FEWEST * size or size < 4 * SLOW or not known.any():
        return None
    frequency, power = (x[SLOW:] for x in welch(known, 1.0 / step, nperseg=size))
    ratio = frequency[:, None] / frequency
    near = (ratio < NEAR) & (ratio > 1.0 / NEAR)
    around = (ratio < AROUND) & (ratio > 1.0 / AROUND) & ~near
    usual = np.array([np.median(power[k]) if k.any() else np.inf for k in around.T])
    over = np.divide(power, usual, out=np.zeros(power.size), where=usual > 0.0)
    k = int(np.argmax(over))
    part = float(power[near[:, k]].sum() * (frequency[1] - frequency[0]) / np.mean(known**2))
    return Line(float(frequency[k]), part, float(over[k]))


def lines_of(
    replays: Sequence[Replay], predicted: Mapping[str, Sequence[np.ndarray]]
) -> dict[str, Line]:
    """Run -> its strongest line of any channel; runs without one are left out."""
    found: dict[str, Line] = {}
    for i, replay in enumerate(replays):
        step = float(np.median(np.diff(replay.time)))
        for channel in replay.observed:
            one = strongest(left_of(replay, channel, predicted[channel][i]), step)
            if one is None or one.over < STANDS_OUT or one.part < PART:
                continue
            if replay.name not in found or one.over > found[replay.name].over:
                found[replay.name] = one
    return found


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
