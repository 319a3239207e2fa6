"""Where rows are missing a row's number is not its time."""

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.tip.rig import TipRig

EVERY = 0.002 * np.arange(5000)
LOST = np.sort(np.random.default_rng(1).permutation(5000)[:4900])
PERIOD = 0.002


def _edges(replay):
    made = TipRig().pack(replay, PERIOD)
    commands = made[4 : 4 + int(made[0])]
    return PERIOD * (1 + np.flatnonzero(np.diff(commands)))


@pytest.mark.parametrize(
    "time", [EVERY, EVERY[LOST], EVERY[(EVERY < 3.2) | (EVERY > 3.7)]], ids=["all", "few", "gap"]
)
def test_rows_may_be_missing(time):
    command = np.where(time % 2.0 < 1.0, 0.0, 5.0)
    inputs = {"command_1": command, "force_x": np.sin(time), "force_y": 0.0 * time}
    edges = _edges(Replay("run", "run", time, inputs, {}, notes={}))
    # Up to the next row that is there.
    assert edges == pytest.approx(np.arange(1.0, 10.0), abs=4 * PERIOD)
