"""How stiff a clutch gives way after reversals, and how wide a play is: where fits begin.

While the motion turns round, the torque goes from friction one way to friction the other.  How far
the rotor turns for that, with the same command before and after, tells the stiffness of what gives
way and the width of what gives nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from ..fitting.replay import Replay
from ..recordings.row_step import row_step
from ..recordings.smoothing import moving_mean
from .signals import RotorSignals

#: Seconds of sliding before a reversal that tell its friction, and within which it must turn round.
BEFORE, WITHIN = 0.1, 1.0
#: Parts of that friction between which a stiffness is read off, on the side that is left.
HIGH, LOW = 0.75, 0.25
#: Samples whose mean crosses zero at a reversal: noise about zero is none.
MEAN = 5
#: Friction in noise of its sensor, and turn in noise of the position, below which nothing is told.
CLEAR, TURNED = 10.0, 3.0


class Winding(NamedTuple):
    """What gives way after a reversal.

    Parameters
    ----------
    stiffness : float
        [N m/rad]
    gap : float
        Turn without torque [rad].
    """

    stiffness: float
    gap: float


class Crossing(NamedTuple):
    """One reversal of the torque, and how far the rotor turns in it.

    `friction` is the torque before it [N m]; `wound` the turn in which that falls from its part
    `HIGH` to `LOW`, `dead` the turn from `LOW` on this side to `LOW` on the other [rad].
    """

    friction: float
    wound: float
    dead: float


def winding(replays: Sequence[Replay], position_noise: float) -> Winding | None:
    """Stiffness and play over all reversals of servo runs, or None where nothing gives way."""
    names = RotorSignals()
    found = [c for replay in replays for c in _crossings(replay, names)]
    least = TURNED * position_noise
    if len(found) < 2 or np.median([max(c.wound, c.dead) for c in found]) < least:
        return None
    # What gives way by less than can be seen is as stiff as that at least.
    soft = float(np.median([max(c.wound, least) / c.friction for c in found]))
    stiffness = (HIGH - LOW) / soft
    dead = float(np.median([c.dead - 2.0 * LOW * c.friction / stiffness for c in found]))
    return Winding(stiffness, max(dead, 0.0))


def _crossings(replay: Replay, names: RotorSignals) -> Iterator[Crossing]:
    seen = replay.observed.get(names.transmitted)
    if seen is None or names.speed in replay.observed:  # driven by torque: set anew, it may swing
        return
    torque, position = seen.values, np.asarray(replay.notes[names.position])
    command = np.asarray(replay.inputs[names.command])
    step = row_step(replay.time)
    before, within = round(BEFORE / step), round(WITHIN / step)
    changes = np.flatnonzero(np.diff(np.sign(moving_mean(torque, MEAN))) != 0)
    # Noise in a play crosses zero as well.
    changes = changes[np.diff(changes, prepend=-within) > before]
    for k in changes[(changes > before) & (changes < torque.size - before)]:
        first, last = max(k - within, 0), min(k + within, torque.size)
        level = float(np.median(torque[first : first + before]))
        side, most = np.sign(level), abs(level)
        if most < CLEAR * seen.sd or np.ptp(command[first:last]) > 0.0:
            continue
        places = [
            _passed(side * torque[first:last], position[first:last], part * most)
            for part in (HIGH, LOW, -LOW, -HIGH)
        ]
        if any(p is None for p in places):
            continue
        high, low, beyond, _ = (p for p in places if p is not None)
        yield Crossing(most, abs(low - high), abs(beyond - low))


def _passed(torque: np.ndarray, position: np.ndarray, level: float) -> float | None:
    """Where a torque that falls has come to a level: the mean of its last place above and below."""
    below = np.flatnonzero(torque <= level)
    if below.size == 0:
        return None
    above = np.flatnonzero(torque[: below[0] + 1] > level)
    if above.size == 0:
        return None
    return 0.5 * float(position[above[-1]] + position[below[0]])
