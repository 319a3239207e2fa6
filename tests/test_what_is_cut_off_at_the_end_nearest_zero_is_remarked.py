"""A sensor with an offset is cut off at either end, also at the one with the smaller number."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.clipping import clipped_inputs
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun

TIME = np.arange(4000) * 0.001
WAVE = np.sin(2 * np.pi * 1.5 * TIME) + 1e-4 * np.random.default_rng(0).normal(size=TIME.size)


def remarks(values):
    channel = ChannelMap("force", "force", "N", "input")
    run = RecordedRun("run 1", "run 1", "", (0, TIME.size), TIME, {"force": values})
    return [found.what for found in clipped_inputs([run], {"force": channel})]


@pytest.mark.parametrize("zero", [-5.0, 0.0, 5.0])
@pytest.mark.parametrize("side", ["largest", "smallest"])
def test_it_is_remarked_at_each_end(zero, side):
    cut = np.minimum(WAVE, 0.7) if side == "largest" else np.maximum(WAVE, -0.7)
    (what,) = remarks(cut + zero)
    assert what.startswith(f"force stays at its {side} value")


def test_what_is_pushed_one_way_rests_at_nothing():
    assert remarks(np.maximum(WAVE, 0.0)) == []
