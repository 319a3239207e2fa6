"""Replay on the condition of what was seen: breakaways as they happened, motion set anew.

A run driven by torque amplifies: breakaway scatters by a per cent, the rotor leaves a few
milliseconds early or late, and from then on a free prediction says nothing about the model.  So
the motion is restarted from the record just after every observed breakaway and at least every
half second of slip; excitations and the effects' own states run on.  The level of each breakaway
is compared on its own.  Runs held by a servo need none of this.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .replay import Breakaway, Restart
from .smoothing import local_fit, local_line, moving_mean

#: Speeds below this many standard deviations of their noise (moving mean of `MEAN` samples) rest.
RESTS_BELOW = 9.0
MEAN = 7
#: Samples of slip that make a breakaway, and of rest that make a stop.
SLIPS_FOR, RESTS_FOR = 6, 12
#: Samples after a breakaway at which the motion is restarted, and samples fitted for its speed.
RESTART_AFTER, FITTED = 3, 14
#: Time before an observed breakaway that is not compared: the model may let go a little early [s].
BLIND = 0.04
#: Longest free prediction of a torque-driven slip [s].
LONGEST = 0.5
#: Samples before a breakaway from which its level is taken, and the least level, in its sd.
LEVEL_FROM, LEAST_LEVEL = 12, 5.0
#: A fall of the transmitted torque in one sample, in level_sd, that noise does not make.
DROP = 7.0


@dataclass(frozen=True)
class Conditions:
    """Restarts, breakaways and the samples to compare of one torque-driven run."""

    restarts: tuple[Restart, ...]
    breakaways: tuple[Breakaway, ...]
    keep: np.ndarray


def observed_slips(speed: np.ndarray, noise: float) -> tuple[list[tuple[int, int]], list[int]]:
    """Where a run that begins at rest starts to slip, and where it stops.

    A start is a pair of samples: the last that may still rest, the first that slips for sure.

    Parameters
    ----------
    speed : ndarray (samples,)
        Measured slip speed.
    noise : float
        Its standard deviation.
    """
    mean = moving_mean(speed, MEAN)
    rests = np.abs(mean) < RESTS_BELOW * noise / np.sqrt(MEAN)
    onsets, stops = [], []
    resting, k = True, MEAN
    while k < speed.size - RESTS_FOR:
        if resting and not rests[k : k + SLIPS_FOR].any():
            onsets.append((_first_motion(speed, mean, k), k))
            resting = False
        elif not resting and rests[k : k + RESTS_FOR].all():
            stops.append(k)
            resting = True
        k += 1
    return onsets, stops


def _first_motion(speed: np.ndarray, mean: np.ndarray, k: int) -> int:
    """Where the speed left zero, from a sample that slips for sure.

    The line through the next samples points back to the instant, or the mean changes sign there:
    the later of the two, since a torque that is taken away bends the line.
    """
    direction = np.sign(mean[k + SLIPS_FOR - 1])
    after = speed[k : k + FITTED]
    start, slope = np.polynomial.polynomial.polyfit(np.arange(after.size), after, 1)
    root = k - start / slope if slope * direction > 0.0 else 0.0
    j = k
    while j > 0 and k - j < SLIPS_FOR and direction * mean[j - 1] > 0.0:
        j -= 1
    return int(np.clip(np.floor(root), j, k))


def _dropped(held: np.ndarray, first: int, sure: int, level_sd: float) -> int:
    """The sample at which the transmitted torque drops to its slip value, if it is to be seen."""
    begin = max(1, first - 2 * SLIPS_FOR)
    fall = -np.diff(np.abs(held[begin - 1 : sure + 2]))
    k = int(np.argmax(fall))
    return begin + k if fall[k] > DROP * level_sd else first


def conditions(
    time: np.ndarray,
    position: np.ndarray,
    speed: np.ndarray,
    held: np.ndarray,
    speed_noise: float,
    level_sd: float,
    scatter: float,
) -> Conditions:
    """How to replay a run driven by torque whose clutch is engaged.

    Parameters
    ----------
    time, position, speed, held : ndarray (samples,)
        Record [s, rad, rad/s, N*m]; `held` is what the stuck clutch transmits: its torque sensor
        where there is one (the load then does not matter), else the applied torque.
    speed_noise : float
        Standard deviation of the speed [rad/s].
    level_sd : float
        Uncertainty of a breakaway's level from noise and from the sampling of the ramp [N*m].
    scatter : float
        Relative scatter of breakaway from one to the next.
    """
    keep = np.ones(time.size, bool)
    restarts: dict[int, Restart] = {}
    breakaways = []
    step = float(np.median(np.diff(time)))
    onsets, stops = observed_slips(speed, speed_noise)
    for onset, sure in onsets:
        again = min(sure + RESTART_AFTER, time.size - 1)
        keep[max(0, onset - round(BLIND / step)) : again] = False
        onset = _dropped(held, onset, sure, level_sd)
        before = held[max(0, onset - LEVEL_FROM) : onset]
        level = local_line(before, before.size - 1) if before.size > 2 else 0.0
        if abs(level) > LEAST_LEVEL * level_sd:  # else it was not friction that held it
            since = max((s for s in stops if s < onset), default=0)
            deviation = float(np.hypot(scatter * level, level_sd))
            breakaways.append(Breakaway(onset, level, deviation, float(time[onset] - time[since])))
        end = next((s for s in stops if s > sure), time.size)
        for k in range(again, end, round(LONGEST / step)):
            restarts[k] = _restart(k, position, speed, sure)
    return Conditions(tuple(restarts[k] for k in sorted(restarts)), tuple(breakaways), keep)


def free_conditions(time: np.ndarray, position: np.ndarray, speed: np.ndarray) -> Conditions:
    """How to replay a run driven by torque whose clutch is off: restarted every half second."""
    every = round(LONGEST / float(np.median(np.diff(time))))
    found = tuple(_restart(k, position, speed, 0) for k in range(every, time.size, every))
    return Conditions(found, (), np.ones(time.size, bool))


def _restart(k: int, position: np.ndarray, speed: np.ndarray, since: int) -> Restart:
    """State at the start of sample k, i.e. at the stamp before it, from samples of one slip."""
    first = max(since + 1, k - 1 - FITTED // 2)
    span = slice(first, min(first + FITTED, speed.size))
    at = k - 1 - first
    return Restart(k, local_fit(position[span], at), local_fit(speed[span], at))
