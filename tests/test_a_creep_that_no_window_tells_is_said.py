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
    channels={"position": SimpleNamespace(written_size=lambda value: f"{value:.2g} rad")}
)


def told(seen, predicted):
    run = Replay("run", "run", TIME, {}, {"position": seen})
    return creeping_sentence(
        SimpleNamespace(replays=[run], after={"position": [predicted]}), RECORDING
    )


def seen(rate, keep=slice(None), **more):
    kept = np.zeros(500, bool)
    kept[keep] = True
    return Observation(rate * TIME + NOISE, 1e-4, kept, windows=WINDOWS, **more)


def test_windows_that_go_on_while_the_model_rests_are_counted_with_the_farthest():
    said = told(seen(0.01), 0.0 * TIME)
    # Half a second less an eighth of it at either end: 0.01 rad/s of 0.38 s.
    assert "In 10 of 10 windows of the runs held out the position goes on by up to 0.0038" in said


@pytest.mark.parametrize(("count", "some"), [(2, False), (3, True)])
def test_a_few_are_none(count, some):
    creeps = np.where(0.5 * count > TIME, TIME, 0.0)
    one = Observation(0.01 * creeps + NOISE, 1e-4, np.ones(500, bool), windows=WINDOWS)
    assert (f"In {count} of 10" in told(one, 0.0 * TIME)) is some


@pytest.mark.parametrize(
    ("one", "predicted"),
    [
        (seen(0.0), 0.0 * TIME),
        (seen(0.01), 0.009 * TIME),
        (seen(0.01), 0.01 * np.sin(50.0 * TIME)),
        (seen(0.01, lines=False), 0.0 * TIME),
        (seen(0.01, keep=slice(0, 500, 50)), 0.0 * TIME),
        (Observation(0.01 * TIME, 1e-4, np.ones(500, bool)), 0.0 * TIME),
    ],
    ids=["rests", "moves with the model", "the model swings", "no lines", "not compared", "whole"],
)
def test_what_is_no_creep_beside_a_model_at_rest_is_not_told(one, predicted):
    assert told(one, predicted) == ""
