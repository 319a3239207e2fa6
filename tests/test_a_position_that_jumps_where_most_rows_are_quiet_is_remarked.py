"""A tracker that slips now and then is told; corners of a motion and even noise are not."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.uneven_noise import uneven_noise_remarks

TIME = np.arange(240) / 30.0
NOISE, JUMP = 1e-4, 5e-3
CHANNEL = ChannelMap("position", "theta", "rad", "measured")


def _swing(off=0.0):
    noise = NOISE * np.random.default_rng(2).standard_normal(TIME.size)
    return 0.2 * np.exp(-0.3 * TIME) * np.cos(3.8 * TIME) + noise + off


def _slipping():
    """Every two seconds it is off for a while."""
    return _swing(JUMP * (np.floor(TIME / 2.0) % 2.0))


def _told(course, channel=CHANNEL):
    run = SimpleNamespace(name="run", rows=(1, 240), time=TIME, channels={"position": course})
    return [f.what for f in uneven_noise_remarks([run], {"position": channel})]


def test_a_slipping_tracker():
    (said,) = _told(_slipping())
    assert "noise of position is not even" in said
    # Three jumps in 240 rows, of which each makes three third differences.
    assert "at 1.2 % the position jumps" in said


def test_a_slip_within_a_row_looks_alike_and_is_said_to():
    rests = 1e-3 * np.floor(TIME / 0.3)
    noise = 2e-6 * np.random.default_rng(1).standard_normal(TIME.size)
    run = SimpleNamespace(
        name="run", rows=(1, 240), time=TIME, channels={"position": rests + noise}
    )
    (said,) = uneven_noise_remarks([run], {"position": CHANNEL})
    assert "at 11 % the position jumps" in said.what  # 26 slips
    assert "a slip that is over within a row, which looks alike" in said.right


def test_not_where_its_noise_is_known():
    channel = ChannelMap("position", "theta", "rad", "measured", noise=0.01)
    assert _told(_slipping(), channel) == []


@pytest.mark.parametrize(
    "course",
    [_swing(), np.abs(_swing()), np.maximum(_swing(), 0.0)],
    ids=["even noise", "bounces", "stops at an end"],
)
def test_neither_even_noise_nor_corners(course):
    assert _told(course) == []
