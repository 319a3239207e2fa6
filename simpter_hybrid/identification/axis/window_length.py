"""How long a free prediction has to be for positions to tell what the forces do.

Half a second is enough where a sensor resolves what a force does in it.  A ball on a beam, seen by
a sensor of 2 mm, leaves a straight line by less than that in half a second and by 50 mm in a run:
in short windows every model is as good as any other, one that never moves among them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

import numpy as np
from scipy.signal import detrend

from ..recordings.checks import Finding
from ..recordings.gaps import runs_between_gaps
from ..recordings.noise import channel_noise
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from .signals import AxisSignals
from .windows import WINDOW, window_samples

#: Windows are long enough where positions leave a straight line by so many times their noise, root
#: mean square; else they are twice as long, and so on.  Those of half a second leave one by 11
#: times (a cylinder) to 160,000 times (an axis with an encoder) in all other recordings at hand.
SEEN = 5.0
#: Below this many times it any model is as good as another: noise alone leaves one by once.
HARDLY = 2.0
#: Beginning of the remark that it is so.
UNTESTED = "positions leave a straight line by hardly more than noise"
#: No window is longer [s], nor longer than half a run: what a start's error does grows with it, and
#: a run may have to be halved.
LONGEST_WINDOW = 8.0


def window_length(recording: Recording, s: AxisSignals) -> float:
    """Length of a run's windows [s]: `WINDOW`, or as much more as its noise asks for.

    Parameters
    ----------
    recording : Recording
        The runs that fit and select.
    s : AxisSignals
    """
    runs = _seen_by_position(recording, s)
    if not runs:
        return WINDOW
    noise = channel_noise(recording, s.position)
    most = min(LONGEST_WINDOW, 0.5 * max(float(run.time[-1] - run.time[0]) for run in runs))
    length = WINDOW
    while bent_by(runs, s.position, length) < SEEN * noise and 2.0 * length <= most:
        length *= 2.0
    return length


def straight(recording: Recording, s: AxisSignals, length: float) -> tuple[Finding, ...]:
    """A remark where positions tell hardly more than straight lines do, in the longest windows.

    Parameters
    ----------
    recording : Recording
        The runs that fit and select.
    s : AxisSignals
    length : float
        Of the windows [s].
    """
    runs = _seen_by_position(recording, s)
    if not runs:
        return ()
    bent, noise = bent_by(runs, s.position, length), channel_noise(recording, s.position)
    if bent >= HARDLY * noise:
        return ()
    what = f"{UNTESTED}, in windows of {length:g} s"
    right = f"{HARDLY:g} times at least: what the forces do is hardly seen, and no model is tested"
    value = f"{bent / noise:.2g} times the noise"
    return (Finding.of_all(what, value, right),)


def _seen_by_position(recording: Recording, s: AxisSignals) -> list[RecordedRun]:
    """All runs, if none of them has a measured speed, which tells forces at once."""
    runs = runs_between_gaps(recording, (), WINDOW)
    return [] if any(s.speed in run.channels for run in runs) else runs


def bent_by(runs: Collection[RecordedRun], position: str, length: float) -> float:
    """By how much positions leave a straight line in windows, root mean square [SI]."""
    squares = [
        float(np.mean(np.square(rest))) for run in runs for rest in _rests(run, position, length)
    ]
    return float(np.sqrt(np.mean(squares))) if squares else 0.0


def _rests(run: RecordedRun, position: str, length: float) -> Iterator[np.ndarray]:
    step = row_step(run.time)
    rows = min(window_samples(step, length), run.time.size)
    for k in range(0, run.time.size - rows + 1, rows):
        yield detrend(run.channels[position][k : k + rows])
