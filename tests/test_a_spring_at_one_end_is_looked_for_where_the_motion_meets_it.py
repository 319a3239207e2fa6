"""The recorded motion of a driven slide tells where a buffer is met, and how stiff it is."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.position_waves import Balance, end_met
from simpter_hybrid.identification.fitting.replay import Replay

TIME = 2e-3 * np.arange(6000)
RATE, EDGE = 30.0, 0.013
POSITION = 0.05 * np.sin(1.9 * TIME) + 0.03 * np.sin(5.3 * TIME + 1.0)
SPEED = np.gradient(POSITION, TIME)


def _balance(side, rate=RATE):
    """Friction, drag, a drive and the buffer."""
    drive = np.cos(0.7 * TIME)
    pushed = side * np.maximum(side * (POSITION - side * EDGE), 0.0)
    course = 3.0 * drive - 1.5 * np.sign(SPEED) - 0.4 * SPEED - rate * pushed
    course += 0.2 * np.random.default_rng(6).standard_normal(TIME.size)
    return lambda replay: Balance(course, drive[:, None], np.ones(TIME.size, dtype=bool))


def _replay():
    notes = {"position": POSITION, "speed": SPEED}
    return Replay("run", "run", TIME, {}, {}, notes=notes)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_at_either_end(side):
    rate, edge = end_met([_replay()], side, _balance(side))
    # 6000 rows of 0.2 m/s^2, some 2000 of them beyond the edge by 20 mm: 0.2/sqrt(2000)/0.02 = 0.2,
    # tenfold for what a line and a parabola do as well; a place is that over the rate times 20 mm.
    assert rate == pytest.approx(RATE, abs=2.0)
    assert edge == pytest.approx(side * EDGE, abs=2e-3)


def test_nothing_that_would_pull_out():
    assert end_met([_replay()], 1.0, _balance(1.0, rate=-RATE)) is None
