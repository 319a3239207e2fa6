"""The state in which each window of an axis starts, from the rows around it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..fitting.replay import Replay
from ..recordings.checks import Finding
from ..recordings.smoothing import even_step, from_row, local_fit
from ..rigs.start_state import ToldState, first_told, state_at_zero, told_at_zero
from .windows import CUBIC, half_width, span_of

#: The degree if the speed was measured (`local_fit`).
PARABOLA = 2
#: A start is fitted to at least so many more rows than the degree, one more than it needs.
MORE = 2
#: A cubic does not serve the first rows if it leaves so many times the noise, and so many times
#: what those of most windows leave (vibrations, noise of another colour).
MISFIT = 3.0
#: The first window is not compared if even then so many times as much is left: of a slide's null,
#: whose servo begins with the weight to lift, it held 5 to 8 times the floor at 10 and at 20 ms a
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
    half, size, found = half_width(float(np.median(np.diff(time)))), position.size, []
    step = even_step(time)
    for k in starts:
        reach, degree = (half, PARABOLA) if sd is None else (2 * half, CUBIC)
        first, last = span_of(k, reach, size, bent, max(degree + MORE, reach))
        rows, at = slice(first, last), k - first
        t = from_row(time, k, rows, step)
        if sd is not None:
            found.append(state_at_zero(t, position[rows], sd, CUBIC))
        else:
            uneven = t if step is None else None
            q, v = (local_fit(x[rows], at, uneven) for x in (position, speed))
            found.append((q, v))
    return found


def told_starts(
    time: np.ndarray, position: np.ndarray, starts: Sequence[int], sd: float, bent: np.ndarray
) -> list[ToldState]:
    """What rows of a position with noise `sd` tell of each start.

    As `start_states`, but of a run's first row by as many as a cubic serves, where it serves those
    of most windows and not these: a record may begin while a force still rises.
    """
    reach, step = 2 * half_width(float(np.median(np.diff(time)))), even_step(time)
    spans = [span_of(k, reach, position.size, bent, max(CUBIC + MORE, reach)) for k in starts]
    near = [
        (from_row(time, k, slice(*span), step), position[slice(*span)])
        for k, span in zip(starts, spans, strict=True)
    ]
    found = [told_at_zero(*rows, sd, CUBIC) for rows in near]
    if len(found) < WINDOWS or starts[0] > 0 or sd <= 0.0:
        return found
    usual = float(np.median([told.left for told in found[1:]]))
    if found[0].left > MISFIT * max(sd, usual):
        found[0] = first_told(*near[0], CUBIC + MORE, sd, CUBIC)
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
