"""What repeated runs differ by, where drive or motion was measured: no model could leave less.

Runs that were told the same are compared as they are (`floor`).  Where the drive or the motion was
measured no two runs have the same, and windows start from measured states; so not the records but
what a model leaves of them is compared.  A lack leaves the same in every repetition; noise of any
colour, and friction that does not repeat, do not.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np

from .alike import put_together
from .floor import Floors
from .predictor import Predictor
from .replay import Replay
from .residual import deviation

#: Two runs are repetitions of one course if their signals differ by less than the first part of
#: them, and their lengths by less than the second.  What they still lack in common counts with its
#: square.
ALIKE, AS_LONG = 0.15, 0.02
#: The first part for runs that are followed whole.  What a lack does early stays in the rest of
#: such a run: of a mass on a spring let go from 55 and 60 mm they differed by three fifths of what
#: was missing.
ALIKE_WHOLE = 0.02
#: What drives, and what moves, by the beginnings of their names.  If both change alike in two runs
#: (a correlation of so much, either way: noise has none) at levels that differ by more than the
#: part of the change that is alike, and of themselves, these are two steps of a staircase.  A
#: pressure that was not set to the last per cent, or a servo's drive against the friction of the
#: day, differ alone; a supply that gives half a per cent more is no step.
STEPPED = (("drive", "duty", "torque", "force", "current"), ("speed",))
TOGETHER, LEVEL = 0.5, 0.02
#: Signals whose size is how much they change, wherever their zero is, by the beginnings of their
#: names.  The same course at another place is another one all the same.
PLACES = ("position",)
#: Part of the windows that two runs have in common: fewer are of another course, or of runs that
#: stuck elsewhere.
MOSTLY = 0.5
#: Times the median beyond which a window is left out; a stretch where a run has no windows [s].
OUTLYING, STRETCH = 3.0, 0.5
#: Least number of windows that tell a floor: to a quarter, were the noise the same all through
#: each.
TOLD = 8


class Repeated(NamedTuple):
    """What repeated runs differ by.

    Parameters
    ----------
    times : Floors
        The differences over the floors known otherwise.
    sure : float
        Relative standard error of that of the selecting runs, by how much windows differ from one
        another: it holds however coloured the noise is.
    """

    times: Floors
    sure: float


def same_course(
    a: Mapping[str, np.ndarray], b: Mapping[str, np.ndarray], alike: float = ALIKE
) -> bool:
    """Whether two runs have the same signals but for noise, row by row.

    Parameters
    ----------
    a, b : mapping of str to ndarray (samples,) or (joints, samples)
    alike : float
        Part of them by which they may differ.
    """
    if a.keys() != b.keys() or not all(_near(name, a[name], b[name], alike) for name in a):
        return False
    return not all(
        any(_at_another_level(a[name], b[name], alike) for name in a if name.startswith(kind))
        for kind in STEPPED
    )


def _at_another_level(a: np.ndarray, b: np.ndarray, alike: float) -> bool:
    """Whether two courses change together, at levels that differ by more than a part of that."""
    rows = min(a.shape[-1], b.shape[-1])
    for x, y in zip(np.atleast_2d(a[..., :rows]), np.atleast_2d(b[..., :rows]), strict=True):
        change = max(np.std(x), np.std(y))
        level = max(abs(np.mean(x)), abs(np.mean(y)))
        apart = abs(np.mean(x) - np.mean(y)) > max(alike * change, LEVEL * level)
        common = np.mean((x - np.mean(x)) * (y - np.mean(y)))
        if apart and abs(common) > TOGETHER * np.std(x) * np.std(y):
            return True
    return False


def _near(name: str, a: np.ndarray, b: np.ndarray, alike: float) -> bool:
    sizes = a.shape[-1], b.shape[-1]
    rows = min(sizes)
    if max(sizes) - rows > AS_LONG * rows:
        return False
    a, b = a[..., :rows], b[..., :rows]
    place = name.startswith(PLACES)
    scale = max(np.ptp(x) / 4 if place else np.sqrt(np.mean(x**2)) for x in (a, b))
    return bool(np.sqrt(np.mean((a - b) ** 2)) <= alike * scale)


def course(replay: Replay) -> dict[str, np.ndarray]:
    """Drive and motion of a run by which repetitions are known, by row in the last axis."""
    moved = {k: v for k, v in replay.notes.items() if k.startswith(("position", "speed"))}
    return {**replay.inputs, **moved}


def repetitions(replays: Sequence[Replay], whole: float = ALIKE_WHOLE) -> list[list[Replay]]:
    """Groups of two or more runs, every two of the same course, with windows of the same rows.

    `whole`: part of their signals by which runs that are followed whole may differ.

    Whatever was logged beside them: what that does is asked of the best models before it counts as
    what does not come again (`repeated_over`).  Runs in which nothing changes and whose place
    nobody knows are none: what lacks along the way comes at other instants in each.
    """
    told = [r for r in replays if not r.drive_is_exact and _tells_where(r)]
    groups = put_together(told, partial(_repeats, whole=whole), _size)
    return [group for group in groups if len(group) > 1]


def _repeats(a: Replay, b: Replay, whole: float) -> bool:
    """Whether two runs are of one course, by the bound `whole` if either is followed so."""
    alike = whole if a.followed or b.followed else ALIKE
    return (
        a.setting == b.setting and _same_windows(a, b) and same_course(course(a), course(b), alike)
    )


def _size(replay: Replay) -> list[tuple[str, float]]:
    """Where a run is among those of nearly one course: how large its signals are."""
    return sorted((name, float(np.mean(x**2))) for name, x in course(replay).items())


def _tells_where(replay: Replay) -> bool:
    """Whether signals tell where in its course a run is: a place does, or anything that changes.

    A place that is a speed summed up is neither compared nor prescribed.
    """
    if any(name.startswith(PLACES) for name in (*replay.inputs, *replay.observed)):
        return True
    others = (x for name, x in course(replay).items() if not name.startswith(PLACES))
    return any(np.std(x) > ALIKE * np.sqrt(np.mean(x**2)) for x in others)


def names_of_repetitions(replays: Sequence[Replay]) -> tuple[tuple[str, ...], ...]:
    """Names of the runs of each group of `repetitions`."""
    return tuple(tuple(run.name for run in group) for group in repetitions(replays))


def _same_windows(a: Replay, b: Replay) -> bool:
    """Whether most windows of two runs are of the same rows, in every channel.

    Where they begin noise has a say: of six pairs of a tester's repetitions four had one window
    fewer in one run.  Those of other rows are not compared.
    """
    if a.observed.keys() != b.observed.keys():
        return False
    sizes = {c: max(len(r.observed[c].windows) for r in (a, b)) for c in a.observed}
    return all(n < 2 or len(_common_spans([a, b], c)) >= MOSTLY * n for c, n in sizes.items())


def _common_spans(group: Sequence[Replay], channel: str) -> list[slice]:
    """Rows of the windows of a channel that all runs have; of runs not cut of the stretches."""
    rows = min(r.time.size for r in group)
    cut = any(len(r.observed[channel].windows) > 1 for r in group)
    each = [
        {*itertools.pairwise((*(k for k in window_starts_of(r, channel) if k < rows), rows))}
        for r in (group if cut else group[:1])
    ]
    return [slice(a, b) for a, b in sorted(set.intersection(*each))]


def repeated_floor(
    predictor: Predictor, values: Mapping[str, float], groups: Sequence[Sequence[Replay]]
) -> tuple[float, float]:
    """Root mean square that `repetitions` do not have in common, and its relative standard error.

    In standard deviations, of what a model leaves in each, weighed as a fit weighs it; NaN where
    nothing was repeated.  Windows in which that is far more than in half of all are left out: of a
    model that lacks something one run sticks there and the other does not.
    """
    squares: list[float] = []
    for group in groups:
        predicted = predictor.predict(values, group)
        for channel in group[0].observed:
            left = [left_of(r, channel, predicted[channel][i]) for i, r in enumerate(group)]
            rows = min(e.size for e in left)
            stack = np.stack([e[:rows] for e in left])
            told = np.all(np.isfinite(stack), axis=0)
            stack = np.where(told, stack, 0.0)
            apart = np.sum((stack - stack.mean(axis=0)) ** 2, axis=0) / (len(group) - 1)
            spans = _common_spans(group, channel)
            squares += [float(np.mean(apart[s][told[s]])) for s in spans if told[s].any()]
    if not squares:
        return float("nan"), float("nan")
    usual = np.array(squares)[squares <= OUTLYING**2 * np.median(squares)]
    mean, windows = float(usual.mean()), usual.size
    if windows < 2 or mean == 0.0:
        return float(np.sqrt(mean)), float("inf")
    return float(np.sqrt(mean)), float(usual.std(ddof=1) / np.sqrt(windows) / (2.0 * mean))


def repeated_over(
    floors: Floors,
    models: Sequence[tuple[Predictor, Mapping[str, float]]],
    runs: Mapping[str, Sequence[Replay]],
) -> Repeated | None:
    """What repeated runs differ by, over the floors known otherwise; None where none was repeated.

    By the model that says least.  Of runs that report nothing is asked: theirs, and that of a part
    with fewer than `TOLD` windows to compare, is raised as that of all.

    Parameters
    ----------
    floors : Floors
    models : sequence of (Predictor, values)
    runs : mapping of str to sequence of Replay
        ``fit`` and ``select``.
    """
    known = {id(r): getattr(floors, part) for part in ("fit", "select") for r in runs[part]}
    groups = repetitions([*runs["fit"], *runs["select"]])
    if not groups:
        return None

    def apart(groups: Sequence[Sequence[Replay]]) -> tuple[float, float]:
        found = [repeated_floor(predictor, values, groups) for predictor, values in models]
        # One of which nothing is compared (a model that fails) says nothing, not least.
        return min((one for one in found if not np.isnan(one[0])), default=found[0])

    together, sure = apart(groups)
    if not np.isfinite(together):  # nothing of them is compared
        return None
    usual = np.sqrt(np.mean([known[id(r)] ** 2 for group in groups for r in group]))
    of_part = dict.fromkeys(Floors._fields, together / float(usual))
    for part in ("fit", "select"):
        ids = {id(r) for r in runs[part]}
        own = [group for group in groups if ids & {id(r) for r in group}]
        if sum(map(_windows_apart, own)) >= TOLD:
            floor, sure = apart(own)
            of_part[part] = floor / getattr(floors, part)
        elif part == "select":
            sure = float("inf")
    return Repeated(Floors(**of_part), sure)


def _windows_apart(group: Sequence[Replay]) -> int:
    """Number of independent differences: windows of a group times its runs less one."""
    return (len(group) - 1) * sum(len(_common_spans(group, c)) for c in group[0].observed)


def window_starts_of(replay: Replay, channel: str) -> tuple[int, ...]:
    """First rows of a channel's windows, or of stretches where a run is not cut."""
    seen = replay.observed[channel]
    if len(seen.windows) > 1:
        return seen.windows
    stretches = np.arange(replay.time[0], replay.time[-1], STRETCH)
    return tuple(np.searchsorted(replay.time, stretches).tolist())


def left_of(replay: Replay, channel: str, predicted: np.ndarray) -> np.ndarray:
    """Weighted residual of every row, infinite where the model failed.

    NaN where nothing is compared.
    """
    seen = replay.observed[channel]
    whole = replace(seen, keep=np.ones(seen.keep.size, bool))
    error = deviation(whole, predicted) / seen.sd * seen.weight
    return np.where(seen.keep, np.where(np.isfinite(error), error, np.inf), np.nan)
