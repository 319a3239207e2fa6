"""Windows of an axis's runs: where they start, and in which state.

A start's speed is fitted to the rows around it.  Where the motion turns round friction turns too,
and where a drive jumps the acceleration does: a fit across such a bend has another speed.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import numpy as np
from scipy.signal import savgol_filter

from ..fitting.repeats import same_course
from ..recordings.channel_map import ChannelMap
from ..recordings.gaps import runs_between_gaps
from ..recordings.noise import noise_estimate
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from ..recordings.smoothing import (
    moving_mean,
    rate_of_change,
    speed_width,
    whole,
)
from ..rigs.begun_at_rest import left_as_told
from ..rigs.following import MOVES
from .force_sensor import LONGEST
from .signals import AxisSignals

#: Length of a free prediction: set anew from the record this often [s], if positions tell enough in
#: it (`window_length`).
WINDOW = 0.5
#: Degree of the polynomial that gives a window's start if no speed was measured: the slope of a
#: parabola is wrong where the speed turns.
CUBIC = 3
#: A start's error may make a line as steep as so many standard errors of its speed, and as this
#: part of the window's own rate of change (`steepest`).
ERRORS, GOES = 20.0, 0.5
#: Name under which a replay keeps which of its rows are bent (samples,).
BENT_ROWS = "bent"
#: A motion slower than this part of the largest speed rests, and does not turn round.
SLOW = 0.03
#: A drive jumps if it changes by this part of its range and by so many deviations of its noise.
JUMP, NOISY = 0.1, 7.0


def window_starts(
    recording: Recording, s: AxisSignals, held_out: Collection[str] = (), length: float = WINDOW
) -> dict[tuple[int, int], list[int]]:
    """Samples at which the windows of every run start, by its rows; `length` of theirs [s].

    Repetitions have those of the first, so that what a model leaves of them can be compared; of
    the groups `held_out` none is the first of one that is not.
    """
    found: dict[tuple[int, int], list[int]] = {}
    firsts: list[RecordedRun] = []
    runs = runs_between_gaps(recording, (), WINDOW)
    for run in sorted(runs, key=lambda run: run.group in held_out):
        step = row_step(run.time)
        half = half_width(step)
        if (first := next((r for r in firsts if _repeats(run, r, s)), None)) is not None:
            found[run.rows] = [k for k in found[first.rows] if k == 0 or k < run.time.size - half]
            continue
        firsts.append(run)
        late, every = rows_untold(run, s), window_samples(step, length)
        starts = list(range(late, max(late + 1, run.time.size - half), every))
        measured = s.speed in run.channels
        course = run.channels[s.speed if measured else s.position]
        wide = half if measured else 2 * half
        places = smooth_places(course, starts, wide, bends_of(run, s, recording.channels))
        found[run.rows] = [0, *places] if late else places
    return found


def rows_untold(run: RecordedRun, s: AxisSignals) -> int:
    """Number of first rows to ignore because of commands from before the record.

    A commanded drive that is late may still be executing them.  0 for a short run, for a drive
    that a sensor saw, and for a run that leaves its rest under its first drive: nothing was told
    before, and its first rows tell how late the drive can be at most.
    """
    if not {*s.drive} & {*s.told} & run.channels.keys():
        return 0
    if _new_at_rest(run, s):
        return 0
    rows = int(np.searchsorted(run.time, run.time[0] + LONGEST))
    return rows if run.time[-1] - run.time[0] > 2.0 * WINDOW else 0


def _new_at_rest(run: RecordedRun, s: AxisSignals) -> bool:
    """Whether a run begins at rest, and leaves under a drive that is new to it then."""
    told = [run.channels[n] for n in s.drive if n in s.told and n in run.channels]
    off = s.engaged in run.channels and not run.channels[s.engaged][0]
    if off or s.position not in run.channels or len(told) != 1 or not told[0][0]:
        return False
    position = run.channels[s.position]
    known = run.channels.get(s.speed)
    speed = known if known is not None else rate_of_change(
        run.time, position, speed_width(row_step(run.time))
    )  # fmt: skip
    if not abs(speed[0]) <= MOVES * float(np.nanmax(np.abs(speed))):
        return False
    return left_as_told(run.time, position, told[0]) is True


def _repeats(run: RecordedRun, first: RecordedRun, s: AxisSignals) -> bool:
    """Whether a run was driven, and moved, as an earlier one."""
    own = (s.position, s.speed, *s.drive, s.supply, s.reference)
    one, other = ({k: v for k, v in r.channels.items() if k in own} for r in (run, first))
    return same_course(one, other)


def window_samples(step: float, length: float = WINDOW) -> int:
    """Samples of a window: half a second if not told, or eight where they are few."""
    return max(8, whole(length / step))


def half_width(step: float) -> int:
    """Samples on either side from which a start's speed is fitted."""
    return max(3, whole(0.5 * speed_width(step) / step))


def bends_of(run: RecordedRun, s: AxisSignals, channels: Mapping[str, ChannelMap]) -> np.ndarray:
    """Rows at which a run turns round, or what drives it jumps (bends,), in order."""
    step = row_step(run.time)
    if s.speed in run.channels:
        speed = moving_mean(run.channels[s.speed], 2 * half_width(step) + 1)
    else:
        speed = rate_of_change(run.time, run.channels[s.position], speed_width(step))
    found = [turns(speed, 4 * half_width(step))]
    drives = (d for d in s.drive if d in run.channels)
    found += [jumps(run.channels[d], channels[d].held, d in s.told) for d in drives]
    return np.unique(np.concatenate(found))


def turns(speed: np.ndarray, near: int) -> np.ndarray:
    """Rows at which a motion turns round: where it stops and goes on, if it rests between.

    Speeds within a small part of the largest are a rest, whose noise turns nothing.  A rest of up
    to `near` rows is one turn.
    """
    least = SLOW * float(np.abs(speed).max())
    moving = np.flatnonzero(np.abs(speed) > least)
    back = np.flatnonzero(speed[moving][1:] * speed[moving][:-1] < 0.0)
    found: list[int] = []
    for last, first in zip(moving[back].tolist(), moving[back + 1].tolist(), strict=True):
        if first - last > near:
            found += [last + 1, first - 1]
        else:
            found.append(last + 1 + int(np.argmin(np.abs(speed[last + 1 : first + 1]))))
    return np.array(found, int)


def jumps(drive: np.ndarray, held: str, told: bool = False) -> np.ndarray:
    """Rows at which a force jumps: by a part of its range, and by more than noise does.

    What was `told` has no noise: what it does every few rows would be taken for that.
    """
    rises = np.abs(np.diff(drive))
    least = max(JUMP * float(np.ptp(drive)), 0.0 if told else NOISY * noise_estimate(drive))
    after = np.flatnonzero(rises > least) + 1
    if held == "after":
        return after
    # What held up to its stamp has changed with the row before; a line bends at both its ends.
    return after - 1 if held == "before" else np.union1d(after - 1, after)


def span_of(k: int, half: int, size: int, bent: np.ndarray, least: int) -> tuple[int, int]:
    """First row and one past the last from which a start at row `k` is fitted.

    Up to `half` rows on either side that no bend parts from it; of a bend itself those on the wider
    side.  Where bends leave fewer than `least` rows it goes across them.
    """
    i = int(np.searchsorted(bent, k))
    below = int(bent[i - 1]) if i > 0 else 0
    at = i < bent.size and bent[i] == k
    j = i + 1 if at else i
    above = int(bent[j]) if j < bent.size else size - 1
    if at:
        below, above = (below, k) if k - below > above - k else (k, above)
    first, last = max(0, k - half, below), min(size, k + half + 1, above + 1)
    if last - first < least:
        return max(0, k - half), min(size, k + half + 1)
    return first, last


def smooth_places(
    course: np.ndarray, starts: Sequence[int], half: int, bent: Sequence[int] | np.ndarray = ()
) -> list[int]:
    """Starts of windows: near `starts`, where a cubic fits best; the first is not earlier.

    Beside a stop or a reversal friction bends the course, and no fit tells the speed there.  The
    rows `bent`, in order, are kept away from as far as a fit reaches, or as far as can be: in noise
    it does not show that it was off by 0.3 rad/s there.  For these alone the first start goes on,
    if it is not that of the record.
    """
    width = 2 * half + 1
    if len(starts) < 2 or course.size < width:
        return list(starts)
    misfit = moving_mean((course - savgol_filter(course, width, CUBIC)) ** 2, width)
    edges = np.array([-course.size, *bent, 2 * course.size])
    first, best, reach = starts[0], [], (starts[1] - starts[0]) // 4

    def off(near: np.ndarray) -> np.ndarray:
        i = np.searchsorted(edges, near)
        return np.minimum(np.minimum(near - edges[i - 1], edges[i] - near), half)

    for k in starts[1:]:
        near = np.arange(k - reach, min(k + reach + 1, course.size))
        best.append(int(near[np.lexsort((misfit[near], -off(near)))[0]]))
    if first > 0:
        first += int(np.argmax(off(np.arange(first, first + reach + 1))))
    return [first, *best]


def steepest(
    position: np.ndarray, starts: Sequence[int], half: int, sd: float
) -> tuple[float, ...]:
    """Largest slope [SI/sample] of the line that may be removed from each window.

    A line is removed because the speed at a window's start is uncertain.  Allowed are many standard
    errors of that speed, and half of how fast the window goes: a model that rests where the record
    goes on is wrong by all of its speed, and not by its start.
    """
    powers = np.vander(np.arange(-2 * half, 2 * half + 1), CUBIC + 1, increasing=True)
    of_speed = sd * float(np.sqrt(np.linalg.inv(powers.T @ powers.astype(float))[1, 1]))
    spans = zip(starts, (*starts[1:], position.size), strict=True)
    goes = (abs(position[b - 1] - position[a]) / max(1, b - 1 - a) for a, b in spans)
    return tuple(float(ERRORS * of_speed + GOES * rate) for rate in goes)
