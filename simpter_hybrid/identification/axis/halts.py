"""Whether a servo's slide sticks and slips: it halts on its way more often than it is told to.

Every slip begins a little early or late, and all later ones with it: over a whole run a prediction
by nearly right values is as wrong as one by wrong values, and no fit finds its way.
"""

from __future__ import annotations

import numpy as np

from ..recordings.noise import channel_noise
from ..recordings.recording import Recording
from ..recordings.row_step import row_step
from ..recordings.smoothing import derivative, speed_width

#: A halt is slower than this part of a fast speed (its 0.9 quantile); between halts it is faster
#: than that one.
STANDS, GOES = 0.05, 0.3
#: A run sticks and slips if it halts so many times more than its set points (own slides with smooth
#: set points: up to 6 more, those that stick and slip: 12 and more).
MORE = 9
#: Between two halts a slide goes on by at least so many deviations of its sensor's noise, or steps
#: of a coarse sensor: a slow slide that is read coarsely seems to halt at every step.
APART = 10.0


def halts(course: np.ndarray, step: float, least: float) -> int:
    """How often a course stands between two stretches in the same direction.

    Parameters
    ----------
    course : ndarray (samples,)
        Positions [rad or m].
    step : float
        Time between samples [s].
    least : float
        How far it goes on at least between two halts [rad or m].
    """
    speed = derivative(course, step, speed_width(step))
    fast = float(np.quantile(np.abs(speed), 0.9))
    if fast == 0.0:
        return 0
    told = np.where(np.abs(speed) > GOES * fast, np.sign(speed), np.nan)
    told[np.abs(speed) < STANDS * fast] = 0.0
    known = np.flatnonzero(np.isfinite(told))
    changes = known[np.flatnonzero(np.diff(told[known], prepend=np.nan))]
    ways = told[changes]
    between = np.flatnonzero((ways[1:-1] == 0.0) & (ways[:-2] == ways[2:]) & (ways[:-2] != 0.0))
    places = course[changes[between + 1]]
    return int(np.sum(np.abs(np.diff(places, prepend=np.inf)) > least))


def sticks_and_slips(recording: Recording, position: str, reference: str) -> bool:
    """Whether some run of a servo's slide halts on its way where its set points go on."""
    least = APART * channel_noise(recording, position)
    for run in recording.runs:
        if not {position, reference} <= run.channels.keys():
            continue
        step = row_step(run.time)
        seen, asked = (halts(run.channels[n], step, least) for n in (position, reference))
        if seen >= asked + MORE:
            return True
    return False
