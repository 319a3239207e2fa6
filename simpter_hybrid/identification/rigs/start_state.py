"""State at the start of a free prediction, from positions alone."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np

from ..fitting.replay import Replay

#: A sample is read before a restart at its own instant: to begin a window it must come after one
#: that is so much earlier [s].  In it nothing moves by more than a billionth of a second's way.
JUST_BEFORE = 1e-9
#: A speed below this many of its standard deviations is rest; where rows do not stay in place,
#: below so many.
RESTS, MAY_MOVE = 4.0, 2.0


#: A first state is fitted to as many rows as a polynomial serves: it must leave no more than noise
#: (within so many standard errors) and have the speed of those over fewer rows (within so many).
ERRORS, APART = 3.0, 2.5
#: The fit reaches no farther than so long [s]; the number of rows grows by this factor.
LONGEST, GROWS = 0.5, 1.3


def later_starts(replay: Replay) -> list[tuple[float, tuple[float, ...]]]:
    """Just before a window's first sample [s], its state, of all windows but the first."""
    at, states = replay.notes["start_at"][1:], replay.notes["states"][1:]
    return [
        (float(replay.time[k]) - JUST_BEFORE, tuple(y))
        for k, y in zip(at, states.tolist(), strict=True)
    ]


def first_state(
    time: np.ndarray, values: np.ndarray, fewest: int, sd: float, degree: int
) -> tuple[float, float]:
    """Position and speed at the first sample: see `first_told`."""
    return first_told(time, values, fewest, sd, degree).state


def first_told(
    time: np.ndarray, values: np.ndarray, fewest: int, sd: float, degree: int
) -> ToldState:
    """Of the first sample, by as many samples as one polynomial serves.

    A whole run goes by its start: over nine rows of a film a push of 0.1 m/s was none.
    """
    t = time - time[0]
    count = min(fewest, t.size)
    passed = [told_at_zero(t[:count], values[:count], sd, degree)]
    while (count := max(count + 1, round(GROWS * count))) <= t.size and t[count - 1] <= LONGEST:
        told = told_at_zero(t[:count], values[:count], sd, degree)
        apart = (abs(told.speed - o.speed) > APART * o.speed_sd for o in passed)
        if not serves(told, count, sd, degree) or any(apart):
            break
        passed.append(told)
    return passed[-1]


def state_at_zero(t: np.ndarray, values: np.ndarray, sd: float, degree: int) -> tuple[float, float]:
    """Position and speed at time 0 of the polynomial through samples at `t` [s]."""
    return told_at_zero(t, values, sd, degree).state


class ToldState(NamedTuple):
    """What a polynomial through some rows says of the state at time 0.

    `left` is what it leaves of the rows; `stays`: whether they stay in place.
    """

    position: float
    speed: float
    speed_sd: float
    left: float
    stays: bool

    @property
    def state(self) -> tuple[float, float]:
        """Position and speed, which is 0 if it is within noise.

        Rows that go far are in motion, though few of them hardly tell how fast: for these less is
        asked.
        """
        least = RESTS if self.stays else MAY_MOVE
        return self.position, self.speed if abs(self.speed) > least * self.speed_sd else 0.0


def serves(told: ToldState, rows: int, sd: float, degree: int) -> bool:
    """Whether a polynomial through so many rows leaves no more of them than noise."""
    return told.left <= (1.0 + ERRORS / np.sqrt(2.0 * (rows - degree - 1))) * sd


def told_at_zero(t: np.ndarray, values: np.ndarray, sd: float, degree: int) -> ToldState:
    """What the polynomial through samples at `t` says of time 0 [s]."""
    return _told(np.vander(t, degree + 1, increasing=True), values, sd)


def joined_at_zero(
    t: np.ndarray, values: np.ndarray, sd: float, degree: int, bends: Collection[float]
) -> ToldState | None:
    """What polynomials say of time 0 that meet at each of `bends` [s], in place and speed.

    Neighbours differ in all higher powers, or in as many as the rows tell; None if they do not tell
    all squares.
    """
    unit = float(np.abs(t).max())
    columns = np.vander(t / unit, degree + 1, increasing=True)
    # The polynomial is that of time 0: what a neighbour adds counts on the far side of its bend.
    far = [np.maximum(t - b if b >= 0.0 else b - t, 0.0) / unit for b in bends]
    for power in range(2, degree + 1):
        for beyond in far:
            more = np.column_stack([columns, beyond**power])
            count = more.shape[1]
            if count < t.size and np.linalg.matrix_rank(more) == count:
                columns = more
            elif power == 2:
                return None
    told = _told(columns, values, sd)
    return told._replace(speed=told.speed / unit, speed_sd=told.speed_sd / unit)


def _told(columns: np.ndarray, values: np.ndarray, sd: float) -> ToldState:
    """Of what columns (rows, numbers) say of values, by the first two: a place and a speed."""
    rows, numbers = columns.shape
    fit = np.linalg.lstsq(columns, values, rcond=None)[0]
    speed_sd = sd * float(np.linalg.norm(np.linalg.pinv(columns)[1]))
    square = float(np.sum((values - columns @ fit) ** 2))
    left = np.sqrt(square / max(1, rows - numbers))
    stays = float(np.std(values)) <= (1.0 + ERRORS / np.sqrt(2.0 * rows)) * sd
    return ToldState(float(fit[0]), float(fit[1]), speed_sd, float(left), stays)
