"""Positions alone: a straight line is forgiven in every window, and with it a creep."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.creeping import creeping_sentence

TIME = 0.01 * np.arange(500)
NOISE = 1e-4 * np.random.default_rng(1).standard_normal(500)
WINDOWS = tuple(range(0, 500, 50))
RECORDING = SimpleNamespace(
    channels={"position": SimpleNamespace(written_change=lambda value: f"{value:.2g} rad")}
)


def said(rate, predicted=0.0, lines=True):
    """Of a record that creeps at a rate [rad/s], by a model that moves at another."""
    seen = Observation(rate * TIME + NOISE, 1e-4, np.ones(500, bool), windows=WINDOWS, lines=lines)
    run = Replay("run", "run", TIME, {}, {"position": seen})
    told = SimpleNamespace(replays=[run], after={"position": [predicted * TIME]})
    return creeping_sentence(told, RECORDING)


def test_windows_that_go_on_while_the_model_rests_are_counted_with_the_farthest():
    # Over half a second less an eighth at either end: 0.01 rad/s of 0.38 s.
    assert "In 10 of 10 windows of the runs held out the position goes on by up to 0.0038" in said(
        0.01
    )


@pytest.mark.parametrize(
    ("rate", "predicted", "lines"), [(0.0, 0.0, True), (0.01, 0.009, True), (0.01, 0.0, False)]
)
def test_what_rests_moves_with_the_model_or_is_compared_whole_is_none(rate, predicted, lines):
    assert said(rate, predicted, lines) == ""
