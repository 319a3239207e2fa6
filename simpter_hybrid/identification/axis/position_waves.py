"""Where along an axis friction or a force may repeat: wavelengths that the recorded motion shows.

A fit finds a wavelength only from nearby.  So every one that the record can tell is tried in the
recorded motion itself: its acceleration, against the drive, friction by direction and speed, and
one wave.  A spectrum over places finds the most promising; those are tried exactly.  Nothing is
simulated and nothing decided here; a fit begins at the best.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar

from ..fitting.replay import Replay
from ..recordings.row_step import row_step
from ..recordings.smoothing import derivative, smoothed, speed_width

#: Least number of rows in motion for each number that is fitted to them.
FEWEST = 10
#: A wave that comes again fewer times than this in the whole way is named only if it leaves
#: nothing: of friction that was doubled in one place a wave as long as the way explained 73 % and
#: got its name.
AGAIN = 2.0
#: Waves are not seen if they are shorter than the way at a slow speed (this quantile of speeds) in
#: a window of smoothing.
SLOWLY = 0.05
#: The spectrum has so many numbers of waves for each further wave in the whole way, and at most so
#: many places (zeros included) ...
FINER, PLACES = 4, 2**17
#: ... and so many of its highest peaks are tried exactly.
EXACT = 40
#: A motion slower than this part of a fast speed (its 0.9 quantile) is left out: friction may hold.
SLOW = 0.1
#: Places at which a spring at an end may be met, that are tried.
ENDS = 60
#: Most samples that are looked at.
SAMPLES = 20_000
#: Columns, among what else moves the axis, of friction by direction, of the speed, of what drives.
WAY, SPEED, DRIVE = 0, 1, -1


class Wave(NamedTuple):
    """One wave along the coordinate: ``number`` waves in 2 pi of it, with a cosine and a sine.

    Their size is relative to friction, or an acceleration for the wave of a force.
    """

    number: float
    cosine: float
    sine: float


class Repeats(NamedTuple):
    """A wave of a force that other runs show again.

    ``number`` waves in 2 pi of the coordinate, ``times`` in the whole way of the runs that fit;
    ``part`` of the mean square that it takes away of what all else leaves on the other runs.
    """

    number: float
    times: float
    part: float


class Balance(NamedTuple):
    """Acceleration of one run in which a wave is looked for, and what is known of it.

    ``acceleration`` is what friction slows and a force drives (samples,); ``known`` what of it is
    in proportion to something recorded (samples, k).
    """

    acceleration: np.ndarray
    known: np.ndarray
    compared: np.ndarray


class _Motion(NamedTuple):
    """What is known at every sample that is looked at, over all runs; `known` is of a balance."""

    position: np.ndarray
    way: np.ndarray
    acceleration: np.ndarray
    others: np.ndarray
    known: np.ndarray
    width: float


def driven(replay: Replay) -> Balance:
    """Balance in which waves are looked for, of an axis that a recorded drive accelerates."""
    width = speed_width(step := row_step(replay.time))
    v = smoothed(replay.notes["speed"], step, width)
    drive = smoothed(replay.inputs["drive"], step, width)
    return Balance(derivative(v, step, width), drive[:, None], np.ones(v.size, dtype=bool))


def strongest_waves(
    replays: Sequence[Replay],
    balance: Callable[[Replay], Balance] = driven,
    numbers_of: Sequence[Replay] = (),
) -> tuple[Wave, Wave] | None:
    """The wave of friction and the wave of a force that explain most of the recorded motion.

    With `numbers_of` they are as long as those of these runs.  None, where a record is too short or
    too slow to tell any.
    """
    motion = _motion(replays, balance)
    seen = _motion(numbers_of, balance) if numbers_of else motion
    ends = _ends(seen)
    if ends is None or _ends(motion) is None:
        return None
    friction, level = _wave(motion, _number(seen, ends, seen.way), motion.way)
    if level == 0.0:
        return None
    number = _number(seen, ends, np.ones(seen.way.size))
    force, _ = _wave(motion, number, np.ones(motion.way.size))
    return Wave(friction.number, friction.cosine / level, friction.sine / level), force


def end_met(
    replays: Sequence[Replay], side: float, balance: Callable[[Replay], Balance] = driven
) -> tuple[float, float] | None:
    """Place and stiffness of a spring at one end that explain most of the motion.

    Parameters
    ----------
    replays : sequence of Replay
    side : float
        1: it is met above that place; -1: below.
    balance : callable (replay) -> Balance

    Returns
    -------
    tuple of float or None
        Stiffness over inertia [1/s^2] and place [rad or m]; None where nothing pushes back.
    """
    motion = _motion(replays, balance)
    if motion.position.size < FEWEST * (1 + motion.others.shape[1]):
        return None
    basis, left = _beyond_others(motion)

    def at(edge: float) -> tuple[float, float]:
        pushed = side * np.maximum(side * (motion.position - edge), 0.0)
        beyond = pushed - basis @ (basis.T @ pushed)
        square = float(beyond @ beyond)
        slope = float(beyond @ left) / square if square > 0.0 else 0.0
        return slope**2 * square, -slope

    places = np.linspace(motion.position.min(), motion.position.max(), ENDS)[1:-1]
    best = max(places, key=lambda edge: at(edge)[0])
    within = (best - np.diff(places)[0], best + np.diff(places)[0])
    edge = float(minimize_scalar(lambda e: -at(e)[0], bounds=within, method="bounded").x)
    rate = at(edge)[1]
    return (rate, edge) if rate > 0.0 else None


def waves_of(
    parts: Mapping[str, Sequence[Replay]], balance: Callable[[Replay], Balance] = driven
) -> tuple[tuple[Wave, Wave], ...]:
    """Waves at which fits begin: the strongest of the fitted runs, and of the selecting ones.

    Runs that select may be the slow ones: what a screw repeats every 10 mm is too quick to be seen
    in a fast one, though it acts there as well.  How large it is the fitted runs tell alone.
    """
    fitted = parts["fit"]
    found = (strongest_waves(fitted, balance, of) for of in ((), parts["select"]))
    return tuple(waves for waves in found if waves is not None)


def drive_waves(parts: Mapping[str, Sequence[Replay]]) -> tuple[Wave, ...]:
    """Waves of what drives at which fits begin, relative to it: of fitted runs, as `waves_of`."""
    found = (_drive_wave(parts["fit"], of) for of in ((), parts["select"]))
    return tuple(wave for wave in found if wave is not None)


def _drive_wave(replays: Sequence[Replay], numbers_of: Sequence[Replay]) -> Wave | None:
    motion = _motion(replays, driven)
    seen = _motion(numbers_of, driven) if numbers_of else motion
    ends = _ends(seen)
    if ends is None or _ends(motion) is None or not motion.known.any():
        return None
    number = _number(seen, ends, seen.known[:, 0])
    wave, level = _wave(motion, number, motion.known[:, 0], DRIVE)
    return Wave(number, wave.cosine / level, wave.sine / level) if level != 0.0 else None


def seen_again(
    fitted: Sequence[Replay],
    tested: Sequence[Replay],
    balance: Callable[[Replay], Balance] = driven,
) -> Repeats | None:
    """The strongest wave of a force in some runs, and what it takes away on others as it is.

    Nulls of a slide, of motors and of spring-pulled sliders had 0.012 at most there; cogging of 42
    waves a turn at 400 rad/s of phase 0.18.  None where runs are too short or slow to tell any.
    """
    waves, motion = strongest_waves(fitted, balance), _motion(tested, balance)
    if waves is None or motion.position.size < FEWEST * (1 + motion.others.shape[1]):
        return None
    force = waves[1]
    basis, left = _beyond_others(motion)
    wave = _columns(motion, force.number, np.ones(left.size)) @ (force.cosine, force.sine)
    rest = left - (wave - basis @ (basis.T @ wave))
    whole = float(left @ left)
    part = 1.0 - float(rest @ rest) / whole if whole > 0.0 else 0.0
    way = float(np.ptp(_motion(fitted, balance).position))
    return Repeats(force.number, force.number * way / (2.0 * np.pi), part)


def _motion(replays: Sequence[Replay], balance: Callable[[Replay], Balance]) -> _Motion:
    found: list[list[np.ndarray]] = [[], [], [], [], []]
    width = 0.0
    for replay in replays:
        step = row_step(replay.time)
        width = max(width, speed_width(step))
        x, there = replay.notes["position"], balance(replay)
        v = smoothed(replay.notes["speed"], step, speed_width(step))
        moving = there.compared & (np.abs(v) > SLOW * float(np.quantile(np.abs(v), 0.9)))
        others = np.column_stack([np.sign(v), v, np.ones(v.size), x, v * np.abs(v)])
        others = np.column_stack([others, np.cos(x), np.sin(x), there.known])
        rows = (x, np.sign(v), there.acceleration, others, there.known)
        for series, values in zip(found, rows, strict=True):
            series.append(values[moving])
    x, way, acceleration, others, known = (np.concatenate(s) for s in found)
    others = others[:, others.any(axis=0)]  # nothing drives an axis let alone
    few = slice(None, None, max(1, x.size // SAMPLES))
    return _Motion(x[few], way[few], acceleration[few], others[few], known[few], width)


def _ends(motion: _Motion) -> tuple[float, float] | None:
    """Waves in 2 pi of the coordinate: from one in the whole way on, to the shortest seen."""
    if motion.position.size < FEWEST * (1 + motion.others.shape[1]):
        return None
    whole = float(np.ptp(motion.position))
    slow = float(np.quantile(np.abs(motion.others[:, SPEED]), SLOWLY))
    shortest = motion.width * slow
    return (2 * np.pi / whole, 2 * np.pi / shortest) if 0.0 < shortest < whole else None


def _number(motion: _Motion, ends: tuple[float, float], by: np.ndarray) -> float:
    """Number of the wave that explains most of what all else leaves.

    The wave is multiplied by `by` (rows,): 1 for a force, the direction of motion for friction.
    """
    basis, left = _beyond_others(motion)

    def gain(number: float) -> float:
        wave = _columns(motion, number, by)
        beyond = wave - basis @ (basis.T @ wave)
        size = np.linalg.lstsq(beyond, left, rcond=1e-6)[0]
        return float(left @ (beyond @ size))

    coarse = max(_promising(motion.position, left * by, *ends), key=gain)
    # Half a step of the spectrum off, a wave would be a sixteenth of a turn off at the ends.
    step = 0.5 * ends[0] / FINER
    within = (coarse - step, coarse + step)
    return float(minimize_scalar(lambda n: -gain(n), bounds=within, method="bounded").x)


def _wave(
    motion: _Motion, number: float, by: np.ndarray, beside: int = WAY
) -> tuple[Wave, float]:  # fmt: skip
    """That wave and one of the columns `beside` it, fitted together, as accelerations."""
    together = np.column_stack([_columns(motion, number, by), motion.others])
    size = np.linalg.lstsq(together, motion.acceleration, rcond=1e-9)[0]
    return Wave(number, float(size[0]), float(size[1])), float(size[2:][beside])


def _beyond_others(motion: _Motion) -> tuple[np.ndarray, np.ndarray]:
    """What is known without a wave or an end, orthonormal, and what that leaves."""
    basis = orthonormal(motion.others)
    return basis, motion.acceleration - basis @ (basis.T @ motion.acceleration)


def orthonormal(columns: np.ndarray) -> np.ndarray:
    """A basis (rows, k) of what columns (rows, k) of any size span."""
    basis, _ = np.linalg.qr(columns / (np.linalg.norm(columns, axis=0) + 1e-30))
    return basis


def _promising(position: np.ndarray, left: np.ndarray, first: float, last: float) -> list[float]:
    """Numbers at the highest peaks of the spectrum of `left` over places."""
    places = int(min(PLACES // FINER, 2 ** np.ceil(np.log2(8.0 * last / first))))
    edges = np.linspace(position.min(), position.max(), places + 1)
    sums, _ = np.histogram(position, edges, weights=left)
    power = np.abs(np.fft.rfft(sums, FINER * places)) ** 2
    numbers = np.arange(power.size) * first / FINER
    inside = np.flatnonzero((numbers >= 0.99 * first) & (numbers <= last))
    rises = np.diff(power[inside], prepend=-np.inf, append=-np.inf)
    peaks = inside[(rises[:-1] > 0) & (rises[1:] <= 0)]
    order = peaks[np.argsort(-power[peaks], kind="stable")][:EXACT]
    around = first / FINER * np.array([-0.5, 0.0, 0.5])
    return [float(n) for k in order for n in numbers[k] + around]


def _columns(motion: _Motion, number: float, by: np.ndarray) -> np.ndarray:
    angle = number * motion.position
    return by[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
