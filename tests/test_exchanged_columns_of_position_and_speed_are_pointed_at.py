"""A pair that agrees far better exchanged is refused; one that agrees neither way is remarked."""

from types import SimpleNamespace

import numpy as np
import pytest
from axis_recordings import LET_ALONE, written

from simpter_hybrid.identification.recordings.exchanged import exchanged, hardly_together
from simpter_hybrid.identification.recordings.motion import Motion
from simpter_hybrid.problems import InvalidInput

TIME = np.arange(0.0, 4.0, 0.005)
MAP = {name: SimpleNamespace(role="measured") for name in ("position", "speed")}
MOVES = {"position": Motion(1.0, 1e3)}


def _stepped():
    """A bar that a servo swings to and fro in steps of a second."""
    angle, rate, at = np.zeros(TIME.size), np.zeros(TIME.size), [0.0, 0.0]
    for k in range(TIME.size):
        angle[k], rate[k] = at
        force = 225.0 * ((0.3 if TIME[k] % 2.0 < 1.0 else -0.3) - at[0]) - 18.0 * at[1]
        at[1] += 0.005 * force
        at[0] += 0.005 * at[1]
    return angle, rate


ANGLE, RATE = _stepped()
NOISE = np.random.default_rng(5).normal(size=TIME.size)


def _runs(position, speed):
    return [(TIME, {"position": position, "speed": speed})]


def test_they_are_asked_about_as_such():
    (found,) = exchanged(_runs(RATE, ANGLE), MAP)
    assert found.signal == "speed"
    assert "are the columns of the two exchanged? (so it is 1)" in found.right


@pytest.mark.parametrize(
    "pair",
    [
        (ANGLE, RATE),
        (ANGLE, np.interp(TIME - 0.05, TIME, RATE)),  # late
        (ANGLE, RATE + 20.0 * NOISE),
        (ANGLE, -RATE),
        (np.full(TIME.size, 0.3), 0.3 * TIME + 1e-4 * NOISE),  # stuck, and a speed that drifts
        (0.006 * np.round(0.004 * TIME / 0.006), 0.004 + 0.002 * NOISE),  # coarse and slow
        (np.sin(2.0 * TIME), 2.0 * np.cos(2.0 * TIME)),
        (np.sin(TIME), -np.cos(TIME)),  # slow, and the sign is wrong, which is told
    ],
)
def test_a_pair_that_may_be_right_is_not(pair):
    assert not list(exchanged(_runs(*pair), MAP))


def test_their_recording_is_refused(tmp_path):
    rows = ["take,s,angle,rate"]
    rows += [f"{n},{t:.3f},{q:.5f},{v:.5f}" for n in (1, 2)
             for t, q, v in zip(TIME, ANGLE, RATE, strict=True)]  # fmt: skip
    entry = (
        '[channels.{}]\ncolumn = "{}"\nunit = "{}"\nsign = 1\nrole = "measured"\nmay_rest = true\n'
    )
    both = entry.format("position", "rate", "rad") + entry.format("speed", "angle", "rad/s")
    with pytest.raises(InvalidInput, match="columns of the two exchanged"):
        written(tmp_path, rows, LET_ALONE + both)


def test_a_speed_that_tells_nothing_of_a_position_that_moves_is_remarked():
    (remark,) = hardly_together(_runs(ANGLE, 20.0 * NOISE), MAP, MOVES)
    assert "position and speed do not go together" in remark.what
    assert not remark.fatal
    assert not hardly_together(_runs(ANGLE, RATE + NOISE), MAP, MOVES)
    blown = RATE + np.where(TIME[300] == TIME, 1e4, 0.0)
    assert not hardly_together(_runs(ANGLE, blown), MAP, MOVES)
    still = {"position": Motion(0.01, 1e3)}
    assert not hardly_together(_runs(ANGLE, 20.0 * NOISE), MAP, still)
