"""Replay on the condition of what was seen: breakaways as they happened, motion set anew.

A run driven by torque amplifies: breakaway scatters by a per cent, the rotor leaves a few
milliseconds early or late, and from then on a free prediction says nothing about the model.  So
the motion is restarted from the record just after every observed breakaway and at least every
half second of slip; excitations and the effects' own states run on.  The level of each breakaway
is compared on its own.  Runs held by a servo need none of this.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..fitting.replay import Breakaway, Restart
from ..recordings.row_step import row_step
from ..recordings.smoothing import local_fit, local_line, moving_mean

#: Speeds below this many standard deviations of their noise (moving mean of `MEAN` samples) rest.
RESTS_BELOW = 9.0
MEAN = 7
#: A sample slips for sure although it may be this many before the onset that its mean has seen.
HALF = MEAN // 2
#: Samples of slip that make a breakaway, and of rest that make a stop.
SLIPS_FOR, RESTS_FOR = 6, 12
#: Samples after a breakaway at which the motion is restarted, and samples fitted for its speed.
RESTART_AFTER, FITTED = 3, 14
#: Samples before sure slip among which the instant is looked for at which the speed left zero.
BEFORE = 10
#: Time before an observed breakaway that is not compared: the model may let go a little early [s].
BLIND = 0.04
#: Longest free prediction of a torque-driven slip [s].
LONGEST = 0.5
#: Samples before a breakaway from which its level is taken, and the least level, in its sd.
LEVEL_FROM, LEAST_LEVEL = 12, 5.0
#: Time before a breakaway over which it is told how fast the torque rose [s].
RISE = 0.2
#: A fall of the transmitted torque in one sample, in level_sd, that noise does not make.
DROP = 7.0
#: Time after an onset in which a torque far above its level shows a contact that gave way [s].
GIVES_FOR = 0.1
#: A contact that gives while its torque rises between these parts of a level, by more than so many
#: standard deviations of the position, yields and does not break away.
RISES, GIVES_BY = (0.3, 0.9), 6.0
#: A slip is a creeping before breakaway if under the same push the clutch held this much more ...
HELD_MORE = 1.25
#: ... later, and it went less than this part of the way of that push.
PART_OF_WAY = 0.25
#: ... at a command no larger than this many times that of the slip.
SAME_COMMAND = 1.02


@dataclass(frozen=True)
class Conditions:
    """Restarts, breakaways and the samples to compare of one torque-driven run."""

    restarts: tuple[Restart, ...]
    breakaways: tuple[Breakaway, ...]
    keep: np.ndarray


def observed_slips(speed: np.ndarray, noise: float) -> tuple[list[tuple[float, int]], list[int]]:
    """Where a run that begins at rest starts to slip, and where it stops.

    A start is the instant the speed left zero, in samples, and the first that slips for sure.

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
            onsets.append((_leaves(speed, k), k))
            resting = False
        elif not resting and rests[k : k + RESTS_FOR].all():
            stops.append(k)
            resting = True
        k += 1
    return onsets, stops


def _leaves(speed: np.ndarray, k: int) -> float:
    """Where the speed left zero, in samples, near one that slips for sure.

    Zero before, a parabola from there: a straight line through the next samples would point back
    to too early an instant, since a ramp of torque goes on while the rotor gathers speed.
    """
    begin = max(0, k - BEFORE)
    seen = speed[begin : k + MEAN + 1]
    index = np.arange(seen.size)
    least, best = np.inf, float(k)
    for instant in np.arange(0.5, min(k - begin + HALF + 0.5, seen.size - 2), 0.5):
        after = np.maximum(index - instant, 0.0)
        _, rest, *_ = np.linalg.lstsq(np.column_stack([after, after**2]), seen, rcond=None)
        if rest.size and rest[0] < least:
            least, best = float(rest[0]), begin + instant
    return best


def _dropped(held: np.ndarray, left: float, sure: int, level_sd: float) -> float:
    """Instant, in samples, at which the transmitted torque drops to its slip value, if it is seen.

    The first fall: one that is larger may follow where what pushed is taken away at once.
    """
    begin = max(1, int(left) - 2 * SLIPS_FOR)
    fall = -np.diff(np.abs(held[begin - 1 : sure + HALF + 2]))
    falls = np.flatnonzero(fall > DROP * level_sd)
    return begin + int(falls[0]) - 0.5 if falls.size else left


def conditions(
    time: np.ndarray,
    position: np.ndarray,
    speed: np.ndarray,
    held: np.ndarray,
    speed_noise: float,
    level_sd: float,
    scatter: float,
    command: np.ndarray,
    position_noise: float,
) -> Conditions:
    """How to replay a run driven by torque whose clutch is engaged.

    Parameters
    ----------
    time, position, speed, held : ndarray (samples,)
        Record [s, rad, rad/s, N*m]; `held` is what the clutch transmits, by its torque sensor: the
        load does not matter.
    speed_noise : float
        Standard deviation of the speed [rad/s].
    level_sd : float
        Uncertainty of a breakaway's level from noise and from the sampling of the ramp [N*m].
    scatter : float
        Relative scatter of breakaway from one to the next.
    command : ndarray (samples,)
        Of the clutch.
    position_noise : float
        Standard deviation of the position [rad].
    """
    keep = np.ones(time.size, bool)
    restarts: dict[int, Restart] = {}
    breakaways = []
    step = row_step(time)
    onsets, stops = observed_slips(speed, speed_noise)
    instants = [_dropped(held, left, sure, level_sd) for left, sure in onsets]
    levels = [_level(held, instant) for instant in instants]
    begun = [math.ceil(instant) for instant in instants]
    ends = [next((s for s in stops if s > sure), time.size) for _, sure in onsets]
    creeps = creeping(begun, ends, levels, position, held, command)
    for k, ((left, sure), onset, level) in enumerate(zip(onsets, begun, levels, strict=True)):
        again = min(sure + RESTART_AFTER, time.size - 1)
        if creeps[k]:
            restarts[again] = restart_at(again, position, speed, sure)
            continue
        keep[max(0, int(left) - round(BLIND / step)) : again] = False
        until = max(ends[k] - MEAN, onset + round(GIVES_FOR / step))  # a stop is seen late
        gave = (np.sign(level) * held[onset:until]).max(initial=0.0) > (
            HELD_MORE * abs(level) + LEAST_LEVEL * level_sd
        )
        gave = gave or (k > 0 and creeps[k - 1])  # then no instant is that of breakaway
        gave = gave or _given(held[:onset], position, level) > GIVES_BY * position_noise
        if abs(level) > LEAST_LEVEL * level_sd and not gave:  # else it was not friction that held
            since = max((s for s in stops if s < onset), default=0)
            deviation = float(np.hypot(scatter * level, level_sd))
            rested = float(time[onset] - time[since])
            slope = math.copysign(1.0, level) * _rise(time[since:onset], held[since:onset])
            breakaways.append(Breakaway(onset, level, deviation, rested, slope))
        for i in range(again, ends[k], round(LONGEST / step)):
            restarts[i] = restart_at(i, position, speed, sure)
    return Conditions(tuple(restarts[k] for k in sorted(restarts)), tuple(breakaways), keep)


def _level(held: np.ndarray, instant: float) -> float:
    """Torque transmitted at an instant, by a straight line through the samples before it [N m]."""
    onset = math.ceil(instant)
    before = held[max(0, onset - LEVEL_FROM) : onset]
    return local_line(before, before.size - onset + instant) if before.size > 2 else 0.0


def _rise(time: np.ndarray, held: np.ndarray) -> float:
    """How fast the transmitted torque rose last, by a straight line [N m/s]."""
    last = time > time[-1] - RISE if time.size else np.zeros(0, bool)
    if last.sum() <= 2:
        return 0.0
    return float(np.polyfit(time[last] - time[-1], held[last], 1)[0])


def _given(held: np.ndarray, position: np.ndarray, level: float) -> float:
    """How far the contact moved while its torque rose to `level` [rad]."""
    part = np.sign(level) * held / max(abs(level), 1e-300)
    low = max(np.flatnonzero(part < RISES[0]), default=0)
    high = low + int(np.argmax(part[low:] > RISES[1])) if part.size else low
    return float(np.sign(level) * (position[high] - position[low]))


def creeping(
    onsets: Sequence[int],
    stops: Sequence[int],
    levels: Sequence[float],
    position: np.ndarray,
    held: np.ndarray,
    command: np.ndarray,
) -> list[bool]:
    """Which slips are a creeping before breakaway: small ones in a push that held more later.

    A contact that gives a little under load moves and rests many times before it lets go; taken
    for breakaways these would put its level anywhere below.

    Parameters
    ----------
    onsets, stops : sequence of int
        Samples at which slips begin and end.
    levels : sequence of float
        Transmitted just before each.
    position, held, command : ndarray (samples,)
        As in `conditions`; a clutch that is commanded more may hold more.
    """
    sign = np.sign(held)
    turns = np.flatnonzero(sign[1:] != sign[:-1]) + 1
    found = []
    for k, (onset, level) in enumerate(zip(onsets, levels, strict=True)):
        way = np.sign(level)
        over = next((t for t in turns if t > onset and sign[t] == -way), held.size)
        at_most = SAME_COMMAND * command[max(onset - 1, 0)]
        later = [
            j
            for j in range(k + 1, len(onsets))
            if onsets[j] < over and command[onsets[j] - 1] <= at_most
        ]
        more = [j for j in later if way * levels[j] > HELD_MORE * abs(level)]
        ways = [
            abs(position[min(stops[j], position.size - 1)] - position[onsets[j]])
            for j in (k, *more)
        ]
        found.append(bool(more) and ways[0] < PART_OF_WAY * sum(ways))
    return found


def free_conditions(time: np.ndarray, position: np.ndarray, speed: np.ndarray) -> Conditions:
    """How to replay a run driven by torque whose clutch is off: restarted every half second."""
    every = round(LONGEST / row_step(time))
    found = tuple(restart_at(k, position, speed, 0) for k in range(every, time.size, every))
    return Conditions(found, (), np.ones(time.size, bool))


def restart_at(k: int, position: np.ndarray, speed: np.ndarray, since: int) -> Restart:
    """State at the start of sample k, i.e. at the stamp before it, from samples of one slip."""
    first = max(since + 1, k - 1 - FITTED // 2)
    span = slice(first, min(first + FITTED, speed.size))
    at = k - 1 - first
    return Restart(k, local_fit(position[span], at), local_fit(speed[span], at))
