"""A speed that its sensor shows with a ripple: so many waves in a turn, in proportion to the speed.

Tachometers, resolvers and encoders off their axis do that.  A force that repeats with the place
moves a mass the less the faster it passes; a sensor's error stays the same part of the speed.  So
the record itself tells the one from the other where it is of several speeds.  Where each run began
need not be known: each has a phase of its own; of a speed alone each stretch between gaps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy.ndimage import maximum_filter1d
from scipy.optimize import minimize_scalar
from scipy.signal import savgol_filter

from ...units import is_unit
from .channel_map import ChannelMap
from .checks import Finding
from .recorded_run import RecordedRun
from .row_step import row_step
from .smoothing import even_stretches, odd
from .ways import Moved, motions_of

#: Motion is what a cubic over this long follows [s]; a ripple is looked for in what it does not.
MOTION = 0.15
#: A ripple is looked for where so many of its waves, or more, pass in that time.
PASSES = 1.5
#: ... and in a run that passes so many of them from its one end to its other: one in each of the
#: quarters of which every other one is to tell the rest (`GOES_ON`).  A bar that was swung by 0.6
#: rad four times alike went on through 1.2 waves, which were the motion's own.
WHOLE = 4.0
#: Most ripples that are looked for; of what turns, of up to so many waves in a radian, of what
#: slides, with so many rows in each at the usual speed.
MOST, SHORTEST, ROWS = 4, 200.0, 4.0
#: For so many of the spectrum's highest lines it is asked whether they are a sensor's.
PEAKS = 5
#: The spectrum has so many numbers of waves for each that the way can tell apart, over so many
#: places.
FINER, PLACES = 4, 2**15
#: A line counts if it is so many times the median of the spectrum: of noise the highest of
#: thousands is a dozen times it.  It is a sensor's if a sensor's ripple explains more than a
#: force's by so many medians ...
STANDS_OUT, MORE = 25.0, 10.0
#: ... if a force's ripple explains less than this part of what the sensor's does ...
FORCES = 0.9
#: ... and if the ripple of every other quarter of the runs explains this part, in the other
#: quarters, of what their own does: a sensor's ripple goes on, what blows and reversals have in
#: common by chance does not.
GOES_ON = 0.5
#: A sensor shows each run the same part of its speed: one part for all explains so much of what one
#: for each run does.  Corners of a motion, which a cubic rounds, make waves in one run alone.
ALIKE = 0.9
#: Largest and smallest part of a speed that a sensor may show so.
LARGEST, SMALLEST = 0.2, 1e-4
#: Fewest rows of a run that are looked at.
LEAST = 50
#: Below this part of the usual speed neither is told from the other.
SLOW = 0.1


class Ripple(NamedTuple):
    """A wave of a sensor's error: ``number`` in a unit of the position, ``part`` of the speed."""

    number: float
    part: float


class _Rest(NamedTuple):
    """Part of a run's speed that no motion explains, where it is compared: in even stretches."""

    position: np.ndarray
    motion: np.ndarray
    rest: np.ndarray
    window: int
    step: float
    stretches: list[slice]
    compared: np.ndarray


def sensors_put_right(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> tuple[list[RecordedRun], list[Finding]]:
    """Runs whose measured speeds have no ripple of their sensors, and remarks on what they had."""
    found, made = [], list(runs)
    for name, channel in channels.items():
        if not name.startswith("speed") or channel.role != "measured":
            continue
        position = name.replace("speed", "position", 1)
        told = [
            (k, rows, moved)
            for k, run in enumerate(made) if name in run.channels
            for rows, moved in motions_of(run, name, position) if moved.time.size > LEAST
        ]  # fmt: skip
        turning = is_unit(channel.unit, "angular_speed")
        speeds, ripples = without_ripple([moved for *_, moved in told], turning)
        for (k, rows, moved), speed in zip(told, speeds if ripples else (), strict=False):
            right = made[k].channels[name].copy()
            right[rows] += speed - moved.speed
            made[k] = replace(made[k], channels={**made[k].channels, name: right})
        found += [_remark(name, ripple, turning) for ripple in ripples]
    return made, found


def _remark(name: str, ripple: Ripple, turning: bool) -> Finding:
    often = f"{ripple.number:.4g} times a turn" if turning else (
        f"every {2e3 * np.pi / ripple.number:.4g} mm")  # fmt: skip
    what = f"{name} shows a ripple in proportion to it, {often}: its sensor's, and taken out"
    value = f"{100 * ripple.part:.2g} % of it"
    return Finding.of_all(what, value, "a sensor without")


def without_ripple(
    runs: Sequence[Moved], turning: bool = True
) -> tuple[list[np.ndarray], tuple[Ripple, ...]]:
    """Every run's speed (samples,) without the ripple of its sensor, and what that was.

    Parameters
    ----------
    runs : sequence of Moved
    turning : bool
        Whether positions are angles [rad] and not lengths [m].
    """
    speeds = [run.speed for run in runs]
    found: list[Ripple] = []
    while len(found) < MOST:
        rests = [_rest(run._replace(speed=v)) for run, v in zip(runs, speeds, strict=True)]
        number = _strongest(rests, turning)
        if number is None:
            break
        sizes = [_fitted(rest, number, of_sensor=True)[1] for rest in rests]
        parts = [float(np.hypot(*size)) for size in sizes if size.any()]
        if not parts or not SMALLEST < max(parts) < LARGEST:
            break
        found.append(Ripple(number, float(np.sqrt(np.mean(np.square(parts))))))
        speeds = [
            v - rest.motion * (_waves(rest, number) @ size)
            for v, rest, size in zip(speeds, rests, sizes, strict=True)
        ]
    return speeds, tuple(found)


def _rest(run: Moved) -> _Rest:
    step = row_step(run.time)
    window = odd(max(MOTION / step, 7.0), run.time.size)
    # A cubic over uneven rows leaves waves of the motion itself, which are no sensor's.
    stretches = even_stretches(run.time, window)
    motion, known = _followed(run.speed, window, stretches), np.zeros(run.time.size, bool)
    for stretch in stretches:
        known[stretch] = True
    compared = known & (np.abs(motion) > SLOW * float(np.quantile(np.abs(motion), 0.9)))
    return _Rest(run.position, motion, run.speed - motion, window, step, stretches, compared)


def _followed(values: np.ndarray, window: int, stretches: Sequence[slice]) -> np.ndarray:
    """What a cubic follows of values (samples, ...) in each stretch; the values outside of them."""
    found = values.copy()
    for stretch in stretches:
        found[stretch] = savgol_filter(values[stretch], window, 3, axis=0)
    return found


def _strongest(rests: Sequence[_Rest], turning: bool) -> float | None:
    """The number of the ripple that explains most; None where none is a sensor's."""
    way = max((float(np.ptp(rest.position)) for rest in rests), default=0.0)
    if way == 0.0:
        return None
    numbers, gains = _spectrum(rests, way, turning)
    if not gains.any():
        return None
    median = float(np.median(gains[gains > 0.0]))
    half = 2.0 * np.pi / way / FINER
    for number in _peaks(numbers, gains, STANDS_OUT * median):
        ends = number - half, number + half
        exact = float(
            minimize_scalar(lambda n: -_gain(rests, n, True), method="bounded", bounds=ends).x
        )
        shown, pushed = (_gain(rests, exact, of_sensor) for of_sensor in (True, False))
        clearly = shown - pushed > MORE * median and pushed < FORCES * shown
        if clearly and _goes_on(rests, exact) and _alike(rests, exact):
            return exact
    return None


def _peaks(numbers: np.ndarray, gains: np.ndarray, least: float) -> list[float]:
    """Numbers of the highest peaks that are so high, the highest first."""
    around = maximum_filter1d(gains, 4 * FINER + 1)
    tops = np.flatnonzero((gains == around) & (gains > least))
    return numbers[tops[np.argsort(-gains[tops], kind="stable")]][:PEAKS].tolist()


def _spectrum(rests: Sequence[_Rest], way: float, turning: bool) -> tuple[np.ndarray, np.ndarray]:
    """Numbers, and about what a sensor's ripple of each explains of all rests (sum of squares).

    None where a wave is too long, or too short, to be seen.
    """
    width = way / PLACES
    numbers = np.arange(PLACES * FINER // 2 + 1) * (2.0 * np.pi / (way * FINER))
    gains = np.zeros(numbers.size)
    fastest, most = 0.0, SHORTEST if turning else np.inf
    for rest in rests:
        at = ((rest.position - rest.position.min()) / width).astype(int)
        weight = np.where(rest.compared, rest.motion, 0.0)
        places = np.bincount(np.minimum(at, PLACES - 1), weight * rest.rest, PLACES)
        square = float(weight @ weight)
        if square > 0.0:
            gains += 2.0 * np.abs(np.fft.rfft(places, PLACES * FINER)) ** 2 / square
        usual = float(np.quantile(np.abs(rest.motion), 0.9))
        fastest = max(fastest, usual)
        if not turning and usual > 0.0:
            most = min(most, 2.0 * np.pi / (ROWS * rest.step * usual))
    longest = 2.0 * np.pi * PASSES / (MOTION * fastest) if fastest > 0.0 else np.inf
    longest = max(longest, 2.0 * np.pi * WHOLE / way)
    seen = (numbers >= longest) & (numbers <= min(most, 0.25 * numbers[-1]))
    return numbers, np.where(seen, gains, 0.0)


def _gain(rests: Sequence[_Rest], number: float, of_sensor: bool) -> float:
    """What a ripple explains of all rests (sum of squares), as a sensor's or as a force's."""
    return sum(_fitted(rest, number, of_sensor)[0] for rest in rests)


def _fitted(rest: _Rest, number: float, of_sensor: bool) -> tuple[float, np.ndarray]:
    """What the best ripple explains of one run's rest, and its cosine and sine."""
    columns, left = _system(rest, number, of_sensor)
    if not left.size:
        return 0.0, np.zeros(2)
    size = _solved(columns, left)
    return float(left @ (columns @ size)), size


def _system(rest: _Rest, number: float, of_sensor: bool) -> tuple[np.ndarray, np.ndarray]:
    """What a cosine and a sine of size one would leave (rows, 2), and what is left (rows,)."""
    passes = number * np.abs(rest.motion) * rest.window * rest.step
    compared = rest.compared & (passes > 2.0 * np.pi * PASSES)
    whole = number * np.ptp(rest.position) >= 2.0 * np.pi * WHOLE
    if not (whole and compared.any()):
        return np.zeros((0, 2)), np.zeros(0)
    by = rest.motion if of_sensor else 1.0 / np.where(compared, rest.motion, np.inf)
    columns = by[:, None] * _waves(rest, number)
    columns = columns - _followed(columns, rest.window, rest.stretches)
    return columns[compared], rest.rest[compared]


def _solved(columns: np.ndarray, left: np.ndarray) -> np.ndarray:
    return np.linalg.lstsq(columns, left, rcond=1e-6)[0]


def _goes_on(rests: Sequence[_Rest], number: float) -> bool:
    """Whether a sensor's ripple of every other quarter of the runs is that of the rest of them."""
    own = others = 0.0
    for rest in rests:
        columns, left = _system(rest, number, of_sensor=True)
        even = (np.arange(left.size) * 4 // max(left.size, 1)) % 2 == 0
        for rows in (even, ~even):
            if rows.any() and (~rows).any():
                told, seen = columns[rows], left[rows]
                own += float(seen @ (told @ _solved(told, seen)))
                there = told @ _solved(columns[~rows], left[~rows])
                others += float(seen @ seen - (seen - there) @ (seen - there))
    return others > GOES_ON * own


def _alike(rests: Sequence[_Rest], number: float) -> bool:
    """Whether a ripple of one size in all runs, of any phase in each, is that of each run alone."""
    along = square = own = 0.0
    for rest in rests:
        columns, left = _system(rest, number, of_sensor=True)
        if left.size:
            size = float(np.sum(columns**2)) / 2.0
            shown = float(np.linalg.norm(columns.T @ left))
            along, square, own = along + shown, square + size, own + shown**2 / size
    return along**2 > ALIKE * square * own


def _waves(rest: _Rest, number: float) -> np.ndarray:
    """Cosine and sine of the place (samples, 2)."""
    angle = number * rest.position
    return np.column_stack([np.cos(angle), np.sin(angle)])
