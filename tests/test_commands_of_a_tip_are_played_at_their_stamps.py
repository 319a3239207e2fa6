"""Where rows are missing a row's number is not its time."""

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.tip.rig import TipRig, _between_gaps

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


def test_a_command_that_a_gap_hides_is_not_compared_until_it_is_forgotten():
    time = EVERY[(EVERY < 3.2) | (EVERY > 3.7)]
    behind = int(np.searchsorted(time, 3.5))
    for command, blind in ((0.0 * time, 0), (np.where(time < 3.5, 0.0, 5.0), 250)):
        spans, keep = _between_gaps(time, [command])
        assert spans == [(0, behind), (behind, time.size)]
        # Half a second in rows of 2 ms, and the first of them.
        assert (~keep).sum() == pytest.approx(blind, abs=1)


def test_a_few_rows_between_gaps_begin_no_window():
    lost = (
        (EVERY > 0.003) & (EVERY < 0.2)
        | (EVERY > 5.0) & (EVERY < 5.1)
        | (EVERY > 5.105) & (EVERY < 5.3)
    )
    time = EVERY[~lost]
    spans, keep = _between_gaps(time, [0.0 * time])
    assert [a for a, _ in spans] == [0, int(np.searchsorted(time, 5.3))]
    assert np.flatnonzero(~keep).size == 2 + np.sum((time > 5.05) & (time < 5.2))
