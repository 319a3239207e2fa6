"""The state in which each window of an axis starts, from the rows around it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..fitting.replay import Replay
from ..recordings.checks import Finding
from ..recordings.row_step import row_step
from ..recordings.smoothing import even_step, from_row, local_fit
from ..rigs.start_state import ToldState, first_told, joined_at_zero, serves, told_at_zero
from .windows import CUBIC, half_width, span_of

#: The degree if the speed was measured (`local_fit`).
PARABOLA = 2
#: A start is fitted to at least so many more rows than the degree, one more than it needs.
MORE = 2
#: A cubic does not serve the first rows if it leaves so many times the noise, and so many times
#: what those of most windows leave (vibrations, noise of another colour).
MISFIT = 3.0
#: The first window is not compared if even then so many times as much is left: of a slide's null,
#: whose servo begins with the weight to lift, it held 2 to 8 times the floor at 10 and at 20 ms a
#: row.  Of fewer windows than these none is like most.
UNTOLD, WINDOWS = 10.0, 4
#: Name under which a replay keeps which first rows are not compared (samples,).
BEGUN_UNTOLD = "begun untold"


def start_states(
    time: np.ndarray, position: np.ndarray, speed: np.ndarray, starts: Sequence[int],
    sd: float | None, bent: np.ndarray,
) -> list[tuple[float, float]]:  # fmt: skip
    """Position and speed at each start; `sd` of the positions, if no speed was measured.

    Each of rows on its own side of the rows `bent`.
    """
    half = half_width(row_step(time))
    if sd is not None:
        near = _near(time, starts, 2 * half, CUBIC, bent)
        return [_told(position, one, sd).state for one in near]
    uneven, found = even_step(time) is None, []
    for k, (rows, t, _) in zip(starts, _near(time, starts, half, PARABOLA, bent), strict=True):
        at, stamps = k - rows.start, t if uneven else None
        found.append(
            (local_fit(position[rows], at, stamps), local_fit(speed[rows], at, stamps))
        )  # fmt: skip
    return found


def told_starts(
    time: np.ndarray, position: np.ndarray, starts: Sequence[int], sd: float, bent: np.ndarray
) -> list[ToldState]:
    """What rows of a position with noise `sd` tell of each start.

    As `start_states`, but of a run's first row by as many as a cubic serves, where it serves those
    of most windows and not these: a record may begin while a force still rises.
    """
    near = _near(time, starts, 2 * half_width(row_step(time)), CUBIC, bent)
    found = [_told(position, one, sd) for one in near]
    if len(found) < WINDOWS or starts[0] > 0 or sd <= 0.0:
        return found
    usual = float(np.median([told.left for told in found[1:]]))
    if found[0].left > MISFIT * max(sd, usual):
        rows, t, _ = near[0]
        found[0] = first_told(t, position[rows], CUBIC + MORE, sd, CUBIC)
    return found


class _Near(NamedTuple):
    """Rows to which a polynomial is fitted for a start, and their times from it on [s].

    `across` are the times of the bends within them, which are too near to be kept out of.
    """

    rows: slice
    time: np.ndarray
    across: np.ndarray


def _told(position: np.ndarray, near: _Near, sd: float) -> ToldState:
    """What a cubic says of a start; where it does not serve across bends, cubics joined at them.

    Unless the rows tell the speed of so many numbers worse than the cubic does by what it leaves.
    """
    given = near.time, position[near.rows], sd, CUBIC
    told = told_at_zero(*given)
    if not near.across.size or serves(told, near.time.size, sd, CUBIC):
        return told
    joined = joined_at_zero(*given, near.across)
    if joined is None or joined.speed_sd * sd > told.speed_sd * told.left:
        return told
    return joined


def _near(
    time: np.ndarray, starts: Sequence[int], reach: int, degree: int, bent: np.ndarray
) -> list[_Near]:
    """The rows of each start."""
    step, least, found = even_step(time), max(degree + MORE, reach), []
    for k in starts:
        rows = slice(*span_of(k, reach, time.size, bent, least))
        t = from_row(time, k, rows, step)
        inside = bent[(bent > rows.start) & (bent < rows.stop - 1)]
        found.append(_Near(rows, t, t[inside - rows.start]))
    return found


def first_untold(told: Sequence[ToldState], sd: float) -> bool:
    """Whether no rows tell the first start, while they tell most others."""
    first, *others = (one.left for one in told)
    return len(told) >= WINDOWS and first > UNTOLD * max(sd, float(np.median(others)))


def begun_untold(replays: Sequence[Replay]) -> tuple[Finding, ...]:
    """Remarks on runs of which the first window is not compared."""
    what = "begins faster than its rows can tell: its first window is not compared"
    right = "rows that follow the motion (a cubic through five), or a run that begins at rest"
    untold = ((r, np.flatnonzero(r.notes.get(BEGUN_UNTOLD, ()))) for r in replays)
    return tuple(
        Finding(r.name, what, f"{r.time[rows[-1] + 1]:.3g} s", right, -1, float("nan"))
        for r, rows in untold
        if 0 < rows.size < r.time.size
    )
