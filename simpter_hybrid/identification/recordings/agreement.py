"""Whether recorded speeds are the rates of the recorded positions: signs and units of a map."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.integrate import cumulative_trapezoid

from .channel_map import ChannelMap
from .checks import Finding
from .projection import beyond
from .row_step import gaps, row_step

#: Movements over this long are compared [s]: longer than sensors lag.
SPAN = 0.1
#: Where a speed swings several times in that, how late it is shows in shorter movements alone [s].
SHORTER = (0.02, 0.005)
#: Correlation from which on the factor between the two is that of the map's units or sign.  Over a
#: tenth of a second noise of a sensor that is worth its name leaves more than this.
SURE = 0.9
#: A sensor may be this factor wrong and still be one to be diagnosed.
FACTOR = 2.0
#: ... and this part off it is worth a question.
GAIN = 0.01
#: A speed is late if that explains this part of how far its integral is off, and this is a part of
#: the movements that is worth a remark.
EXPLAINED, APART = 0.75, 0.03
#: Part of the runs that have to tell: of single short runs some do by chance.
SOME = 0.5
#: Part of a speed's changes that has to be its own: coasting it changes as it goes, in a ramp by as
#: much all the time.
SAME = 0.01
#: Part of the expected movements that has to be no change of the speed, to tell a gain beside it.
TOLD = 0.5
#: Runs with fewer movements are taken together: of two a late speed makes a gain of some per cent.
FEW = 4
#: Movements that tell how late a speed is, or a gain by short runs: by fewer some do by chance.
TELLING = 12

#: Of each run time stamps [s], and signal -> values [SI].
Runs = Sequence[tuple[np.ndarray, Mapping[str, np.ndarray]]]
#: Of each run what its position, its speed summed up, and its speed change by (movements,).
Movements = tuple[np.ndarray, np.ndarray, np.ndarray]
#: What to do about a speed and a position that do not go together in time.
ALONE = (
    "the two at the same instants: leave out the late one, or move it by its `clock_shift` if its "
    "stamps alone are late (a filter's lag is no shift)"
)
#: ... where the speed is behind by half a row, to this part of one (smoothing blurs it).
HALF = 0.1
#: Rows come as often in two runs if the times between them differ by about this part or less.
LIKE = 0.05
DIFFERENCE = (
    "the two at the same instants: leave the speed out, if it was made so; the position tells as "
    "much, and a mean over a row that is moved in time has bends that the motion has not"
)


class Disagreement(NamedTuple):
    """A speed that is not the rate of its position."""

    signal: str
    what: str
    factor: float
    right: str


def disagreements(runs: Runs, channels: Mapping[str, ChannelMap]) -> Iterator[Disagreement]:
    """Speeds that go against the positions recorded beside them, or at another scale.

    Parameters
    ----------
    runs : sequence of (ndarray (samples,), mapping of str to ndarray (samples,))
        Time stamps [s], and signal -> values [SI].
    channels : mapping of str to ChannelMap
    """
    for speed, position, pairs in beside(runs, channels):
        moved, expected, _ = (np.concatenate(part) for part in zip(*pairs, strict=True))
        if not (slopes := _slopes(moved, expected)):
            continue
        slope = slopes[0]
        what = f"{position} changes by this factor times the speed's integral"
        if slope < 0.0:
            yield Disagreement(speed, what, slope, "1: is the sign of one of them wrong?")
        elif not 1.0 / FACTOR < slope < FACTOR:
            yield Disagreement(speed, what, slope, "1: is the unit of one of them wrong?")


def gains_apart(runs: Runs, channels: Mapping[str, ChannelMap]) -> list[Finding]:
    """Speeds that are, in every run, a little more or less than the rates of their positions.

    Whichever of the two is taken for exact, since noise of one lowers its slope.
    """
    found = []
    for speed, position, least, most in _gains(runs, channels):
        what = f"{position} changes by another amount than {speed} says, in every run"
        right = (
            "1: is the gain of one of them wrong? (`times` in the map puts it right) Or the clock?"
        )
        value = f"{least:.4g} to {most:.4g} times its integral"
        found.append(Finding.of_all(what, value, right))
    return found


def late_speeds(runs: Runs, channels: Mapping[str, ChannelMap]) -> list[Finding]:
    """Remarks on speeds and positions of which one is behind the other.

    A speed made of differences is behind by half a row, whatever the rows of its run: runs whose
    rows come as often are asked together.
    """
    found = []
    told = lateness(runs, channels)
    groups = _of_like_rows(runs) if told else []
    alike = [(step, lateness(some, channels)) for step, some in groups]
    for speed in (name for name in channels if name in told):
        position, late = told[speed]
        behind, ahead = (speed, position) if late > 0.0 else (position, speed)
        each = [(by[speed][1], step) for step, by in alike if speed in by]
        halved = bool(each) and all(abs(t - 0.5 * step) <= HALF * step for t, step in each)
        how = "a difference of rows, or a filter," if halved else "a filter or a late stamp"
        what = f"{behind} is behind {ahead}, as {how} makes it"
        value = " and ".join(f"{1e3 * abs(t):.3g} ms" for t, _ in (each if halved else [(late, 0)]))
        right = DIFFERENCE if halved else ALONE
        found.append(Finding.of_all(what, value, right))
    return found


def _of_like_rows(runs: Runs) -> list[tuple[float, Runs]]:
    """Time between rows [s] and the runs that have it, to some per cent; none of a single row."""
    groups: dict[int, list[int]] = {}
    steps = [row_step(time) if time.size > 1 else 0.0 for time, _ in runs]
    for k, step in enumerate(steps):
        if step > 0.0:
            groups.setdefault(round(math.log(step) / LIKE), []).append(k)
    return [
        (float(np.median([steps[k] for k in some])), [runs[k] for k in some])
        for some in groups.values()
    ]


def lateness(runs: Runs, channels: Mapping[str, ChannelMap]) -> dict[str, tuple[str, float]]:
    """Speed -> its position, and how late it is beside it [s]; of a position that is so < 0."""
    told: dict[str, tuple[str, float]] = {}
    for span in (SPAN, *SHORTER):
        for speed, position, pairs in beside(runs, channels, span):
            if speed not in told and (late := _late_together(pairs)) is not None:
                told[speed] = position, late
    return told


def _late_together(pairs: Sequence[Movements]) -> float | None:
    """How late a speed is by all runs [s]; else by those that tell, if they tell the same way.

    Long steady runs move far, beside which what a late speed is off by in the others is little.
    """
    late = _late(pairs)
    if late is not None:
        return late
    each = [one for run in pairs if (one := _late([run])) is not None]
    same = each and (min(each) > 0.0 or max(each) < 0.0)
    return float(np.median(each)) if same and len(each) >= SOME * len(pairs) else None


def _late(pairs: Sequence[Movements]) -> float | None:
    """How late a speed is [s], negative if it is early; None where that cannot be told.

    Behind a lag of one time constant a speed is less than the rate of its position by that constant
    times its own rate of change; behind a delay it is so too, if the delay is small.
    """
    moved, expected, gained = (np.concatenate(part) for part in zip(*pairs, strict=True))
    others = np.column_stack([expected, np.ones(expected.size)])  # a gain, a zero that is off
    if gained.size < TELLING:
        return None
    off, alone = beyond(moved - expected, others), beyond(gained, others)
    whole = float(moved @ moved)
    size, left = float(alone @ alone), float(off @ off)
    if size <= SAME * float(gained @ gained) or whole == 0.0 or left == 0.0:
        return None
    late = float(off @ alone) / size
    told = late**2 * size / left
    return late if told > EXPLAINED and left > APART**2 * whole else None


def unequal_gains(
    runs: Runs, channels: Mapping[str, ChannelMap]
) -> Iterator[tuple[str, str, float]]:
    """Speeds that are not the rates of their positions, by a factor.

    Yields the name of the speed, that of its position, and the factor that would make it the rate.
    """
    for speed, position, least, most in _gains(runs, channels):
        yield speed, position, (least + most) / 2.0


def _gains(
    runs: Runs, channels: Mapping[str, ChannelMap]
) -> Iterator[tuple[str, str, float, float]]:
    """Speed, position, and the least and largest factor between them in any run, if not about 1."""
    for speed, position, pairs in beside(runs, channels):
        told = [_slopes(*_in_step(run)) for run in _telling(pairs)]
        least, most = (f([f(t) for t in told if t] or [1.0]) for f in (min, max))
        if told and all(told) and (least > 1.0 + GAIN or most < 1.0 - GAIN):
            yield speed, position, least, most


def _telling(runs: Sequence[Movements]) -> list[Movements]:
    """Runs that are long enough to tell a gain, and all that are not as one, if that is."""
    long = [run for run in runs if run[0].size >= FEW]
    if short := [run for run in runs if run[0].size < FEW]:
        moved, expected, gained = (np.concatenate(part) for part in zip(*short, strict=True))
        long += [(moved, expected, gained)] if moved.size >= TELLING else []
    return long


def _in_step(run: Movements) -> tuple[np.ndarray, np.ndarray]:
    """Movements and expected ones without what a late speed makes of them.

    As they are where the speed changes as it goes, and neither can be told from the other.
    """
    moved, expected, gained = run
    changes = float(gained @ gained)
    if changes == 0.0:
        return moved, expected
    beside = [x - gained * float(gained @ x) / changes for x in (moved, expected)]
    told = float(beside[1] @ beside[1]) > TOLD * float(expected @ expected)
    return (beside[0], beside[1]) if told else (moved, expected)


def beside(
    runs: Runs, channels: Mapping[str, ChannelMap], span: float = SPAN
) -> Iterator[tuple[str, str, list[Movements]]]:
    """Speeds with the positions beside them, and what both say of each run's movements."""
    for speed in channels:
        position = speed.replace("speed", "position", 1)
        if not speed.startswith("speed") or position not in channels:
            continue
        if "constant" in (channels[speed].role, channels[position].role):
            continue
        pairs = [
            movements(time, found[position], found[speed], span)
            for time, found in runs
            if speed in found and position in found
        ]
        if pairs:
            yield speed, position, pairs


def _slopes(moved: np.ndarray, expected: np.ndarray) -> tuple[float, float] | tuple[()]:
    """Movements over expected ones, with noise in these and in those; none if they do not tell."""
    together, alone = float(moved @ expected), float(expected @ expected)
    itself = float(moved @ moved)
    if together**2 < SURE**2 * itself * alone or together == 0.0:
        return ()
    return together / alone, itself / together


def ends_of_movements(time: np.ndarray, span: float) -> list[np.ndarray]:
    """Rows at which movements over a span begin and end, of every stretch between gaps."""
    every = max(1, round(span / row_step(time)))
    return [rows[::every] for rows in np.split(np.arange(time.size), gaps(time) + 1)]


def movements(time: np.ndarray, position: np.ndarray, speed: np.ndarray, span: float) -> Movements:
    """Changes of a position over a span, of the speed's integral and of the speed.

    None spans a gap: what a speed was in one, its two ends do not tell.
    """
    known = np.isfinite(position) & np.isfinite(speed)
    time, position, speed = time[known], position[known], speed[known]
    if time.size < 2:
        return np.zeros(0), np.zeros(0), np.zeros(0)
    way = cumulative_trapezoid(speed, time, initial=0.0)
    ends = ends_of_movements(time, span)
    moved, expected, gained = (
        np.concatenate([np.diff(values[at]) for at in ends]) for values in (position, way, speed)
    )
    return moved, expected, gained
