"""Experiments that a driven axis can do: from these the next run is recommended.

A servo moves the axis along a course, within the way, speed and force that were used (what becomes
of it where the drive is weak, `axis.plan` tells).  Each course shows what others confuse: strokes
at several speeds friction against drag, small strokes what is before sliding, the same slow strokes
at other places or after fast ones position against wear and heat, fast sines inertia, steps the
timing of the drive or of its sensor.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

#: A slow stroke has this part of the largest speed; falling speeds go by such steps.
SLOW, FALLING = 1 / 6, (1.0, 0.3, 0.1, 0.03)
#: Fast sines take this part of the largest force for the inertia.
SHAKEN = 0.7
#: Strokes that grow reverse this often [1/s]; of short ones between rests there are so many.
GROWING, SHORT = 1.5, 6

#: A speed or a drive that is less than this part of its largest is next to nothing.
NEXT_TO_NOTHING = 0.05


@dataclass(frozen=True)
class AxisReach:
    """How far an experimenter has gone, taken from the runs that were made.

    Parameters
    ----------
    low, high : float
        Ends of the way that was used [m or rad].
    speed, force : float
        Largest [SI]; the force is that of the drive.
    inertia : float
        [kg or kg m^2]
    duration, step : float
        Of a run and between samples [s].
    """

    low: float
    high: float
    speed: float
    force: float
    inertia: float
    duration: float
    step: float

    @property
    def time(self) -> np.ndarray:
        """Instants of a planned run [s]."""
        return self.step * np.arange(round(self.duration / self.step) + 1)


def most_of(values: np.ndarray, part: float) -> float:
    """Size that `part` of all samples keep within; of those that count, where most are next to 0.

    Parameters
    ----------
    values : ndarray (samples,)
        A speed, an acceleration or a drive, of an axis that may rest most of the time.
    part : float
        From 0 to 1.
    """
    size = np.abs(values)
    counts = size > NEXT_TO_NOTHING * size.max()
    found = float(np.quantile(size, part))
    if found > NEXT_TO_NOTHING * size.max() or not counts.any():
        return found
    return float(np.quantile(size[counts], part))


def ends_of(position: np.ndarray, speed: np.ndarray) -> tuple[float, float]:
    """Between which positions (samples,) it moved, but for 2 % of its samples at either end."""
    fast = np.abs(speed) > NEXT_TO_NOTHING * np.abs(speed).max()
    for rows in (position, position[fast]):
        low, high = np.quantile(rows, (0.02, 0.98)).tolist() if rows.size else (0.0, 0.0)
        if high - low > NEXT_TO_NOTHING * np.ptp(position):
            return low, high
    return float(position.min()), float(position.max())


def axis_experiments(reach: AxisReach) -> dict[str, np.ndarray]:
    """Course (samples,) of every experiment."""
    t, v, last = reach.time, reach.speed, reach.duration
    half, middle = 0.5 * (reach.high - reach.low), 0.5 * (reach.high + reach.low)
    slow = SLOW * v
    reversals = min(half, slow * last / 8.0)
    falling = np.concatenate(
        [strokes(part, s * v, min(half, s * v * last / 16.0)) for s, part in _shared(t, FALLING)]
    )
    ends = [middle - half + reversals, middle, middle + half - reversals]
    places = np.concatenate(
        [at + strokes(part, slow, reversals / 2.0) for at, part in _shared(t, ends)]
    )
    fast, after = np.array_split(t, [int(0.7 * t.size)])
    rate = min(SHAKEN * reach.force / (reach.inertia * v), 0.2 * np.pi / reach.step)
    beat = np.sign(np.sin(2 * np.pi * GROWING * t))
    found = {
        "slow strokes both ways": middle + strokes(t, slow, reversals),
        "strokes both ways at falling speeds": middle + falling,
        "fast sine": middle + min(half, v / rate) * np.sin(rate * t),
        "small strokes that grow": middle
        + min(half, 0.25 * v / GROWING)
        * (t / last) ** 3
        * 2
        / np.pi
        * np.arcsin(np.sin(2 * np.pi * GROWING * t)),
        "short strokes with rests that grow": middle + _with_rests(t, v, half),
        "fast strokes for long, then slow ones": middle
        + np.concatenate([strokes(fast, v, half), strokes(after - after[0], slow, reversals)]),
        "slow strokes at both ends and in the middle": places,
    }
    # From the end of one part to the beginning of the next it moves as well.
    found = {name: no_faster(x, v * reach.step) for name, x in found.items()}
    found["steps to and fro"] = middle + 0.2 * half * beat
    return {name: np.clip(x, reach.low, reach.high) for name, x in found.items()}


def no_faster(course: np.ndarray, most: float) -> np.ndarray:
    """A course (samples,) that follows another by no more than `most` from sample to sample.

    Parameters
    ----------
    course : ndarray (samples,)
    most : float
        [m or rad]
    """
    at, found = float(course[0]), []
    for x in course.tolist():
        at += min(max(x - at, -most), most)
        found.append(at)
    return np.array(found)


def strokes(time: np.ndarray, speed: float, half: float) -> np.ndarray:
    """Course (samples,) to and fro about 0 at one speed, `half` to each side, from 0 on."""
    return half * 2 / np.pi * np.arcsin(np.sin(0.5 * np.pi * speed / half * time))


def _shared(time: np.ndarray, levels):
    """Each level with its share of the time, which begins at 0."""
    for level, part in zip(levels, np.array_split(time, len(levels)), strict=True):
        yield level, part - part[0]


def _with_rests(time: np.ndarray, speed: float, half: float) -> np.ndarray:
    """Strokes of equal length to and fro; the rests between them grow threefold each time."""
    rests = 3.0 ** np.arange(SHORT)
    each = 0.4 * time[-1] / SHORT
    corners, places, at = [0.0], [0.0], 0.0
    for k, rest in enumerate(0.6 * time[-1] * rests / rests.sum()):
        corners += [at + rest, at + rest + each]
        places += [places[-1], (-1) ** k * min(half, 0.25 * speed * each)]
        at += rest + each
    return np.interp(time, corners, places)
