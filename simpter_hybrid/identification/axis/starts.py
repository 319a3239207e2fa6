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
#: A cubic that leaves so many times the noise does not serve its rows: fewer are taken, by this
#: part and down to so many on either side.
MISFIT, FEWER, FEWEST = 3.0, 0.8, 3
#: Of so many windows the first is not compared if its cubic leaves so many times the noise,
#: and so many times what those of most others leave: of a slide's null, whose servo begins with
#: the weight to lift, it held 5 to 8 times the floor at 10 and at 20 ms a row.
WINDOWS, UNTOLD = 4, 10.0
#: Name under which a replay keeps from which row on it is compared, if not from the first.
COMPARED_FROM = "compared from"


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

    As `start_states`, but of fewer rows where a cubic does not serve as many as usual: swings of
    few rows, or a record that begins while a force still rises.
    """
    reach, step = 2 * half_width(float(np.median(np.diff(time)))), even_step(time)
    found = []
    for k in starts:
        first, last = span_of(k, reach, position.size, bent, max(CUBIC + MORE, reach))
        t, x, at = from_row(time, k, slice(first, last), step), position[first:last], k - first
        told, near = told_at_zero(t, x, sd, CUBIC), reach
        if at == 0 and told.left > MISFIT * sd > 0.0:
            told = first_told(t, x, CUBIC + MORE, sd, CUBIC)
        while at > 0 and told.left > MISFIT * sd > 0.0 and near > FEWEST:
            near = max(FEWEST, int(FEWER * near))
            rows = slice(max(0, at - near), at + near + 1)
            if t[rows].size < CUBIC + MORE:
                break
            told = told_at_zero(t[rows], x[rows], sd, CUBIC)
        found.append(told)
    return found


def first_untold(told: Sequence[ToldState], sd: float) -> bool:
    """Whether no rows tell the first start, while they tell most others."""
    first, *others = (max(one.left, sd) for one in told)
    return len(told) >= WINDOWS and first > UNTOLD * max(sd, float(np.median(others)))


def begun_untold(replays: Sequence[Replay]) -> tuple[Finding, ...]:
    """Remarks on runs of which the first window is not compared."""
    what = "begins faster than its rows can tell: its first window is not compared"
    right = "rows that follow the motion (a cubic through five), or a run that begins at rest"
    late = [(r, int(r.notes[COMPARED_FROM])) for r in replays if COMPARED_FROM in r.notes]
    return tuple(
        Finding(r.name, what, f"{r.time[k]:.3g} s", right, -1, float("nan")) for r, k in late
    )
