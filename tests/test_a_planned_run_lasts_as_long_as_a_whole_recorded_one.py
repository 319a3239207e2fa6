"""A run that was cut into pieces is planned again as long as it was, not as long as a piece."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.halves import halves
from simpter_hybrid.identification.axis.plan import LONGEST, axis_reach
from simpter_hybrid.identification.axis.told_plan import motion_reach
from simpter_hybrid.identification.fitting.replay import Replay

STEP, ROWS = 1e-3, 1500


def piece(number: int, before: Replay | None) -> Replay:
    """Of 1.499 s; the next one begins a row later."""
    time = STEP * np.arange(ROWS)
    speed = np.sin(5.0 * time)
    notes = {"position": np.cumsum(speed) * STEP, "speed": speed}
    inputs, stamp = {"drive": np.cos(5.0 * time)}, 7.0 + number * ROWS * STEP
    about = f"piece {number}", "run", time, inputs, {}
    return Replay(*about, notes=notes, stamp=stamp, before=before)


def pieces(count: int) -> list[Replay]:
    found: list[Replay] = []
    for k in range(count):
        found.append(piece(k, found[-1] if found else None))
    return found


@pytest.mark.parametrize("count", [1, 3])
def test_pieces_of_a_run_are_counted_together(count):
    runs = pieces(count)
    whole = (count * ROWS - 1) * STEP
    # Those that fit are the first one alone.
    assert axis_reach(runs[:1], 1.0, 1.0, runs).duration == pytest.approx(whole)
    assert motion_reach(runs[:1], 1.0, runs).duration == pytest.approx(whole)


def test_a_run_of_which_halves_fit_and_select_is_one():
    first, second = halves(piece(0, None))
    assert axis_reach([first], 1.0, 1.0, [first, second]).duration == pytest.approx(1.499)


def test_no_planned_run_is_longer_than_the_longest():
    assert axis_reach(pieces(10), 1.0, 1.0).duration == LONGEST
