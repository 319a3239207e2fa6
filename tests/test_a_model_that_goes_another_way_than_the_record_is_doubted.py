"""Positions alone: half of a straight line is forgiven, and with it a model that is too slow."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.pace import pace_of
from simpter_hybrid.identification.reporting.pace import pace_sentence

TIME = 0.01 * np.arange(500)
WINDOWS = tuple(range(0, 500, 50))
WAY = 0.02 * np.sin(2.5 * TIME)


def said(predicted, **more):
    noisy = WAY + 1e-5 * np.random.default_rng(1).standard_normal(500)
    seen = Observation(noisy, 1e-5, np.ones(500, bool), windows=WINDOWS, **more)
    run = Replay("run", "run", TIME, {}, {"position": seen})
    told = SimpleNamespace(replays=[run], after={"position": [predicted]}, changed=True)
    return pace_sentence(told)


@pytest.mark.parametrize(("part", "words"), [(0.3, " 30 % of the way"), (1.5, " 150 % of the way")])
def test_a_model_that_goes_a_part_of_the_way_everywhere_is_told(part, words):
    assert words in said(part * WAY)


def test_where_it_rests_it_goes_at_no_pace():
    assert said(0.0 * WAY) == ""


def test_errors_of_starts_that_go_either_way_are_not():
    wrong = np.random.default_rng(2).normal(0.0, 0.3, len(WINDOWS))
    assert said(WAY * np.repeat(1.0 + wrong, 50)) == ""


@pytest.mark.parametrize("more", [{"lines": False}], ids=["no lines are taken away"])
def test_where_the_error_tells_it_no_sentence_has_to(more):
    assert said(0.3 * WAY, **more) == ""


def test_the_pace_is_a_line_through_zero_with_its_own_scatter():
    seen = np.array([1.0, 2.0, -3.0])
    assert pace_of(seen, 0.5 * seen) == pytest.approx((0.5, 0.0), abs=1e-12)


def test_one_window_that_goes_far_does_not_speak_for_all():
    seen = np.array([1.0] * 8 + [10.0])
    pace, error = pace_of(seen, np.array([1.0] * 8 + [7.0]))
    assert pace < 0.75
    assert abs(pace - 1.0) < 4.0 * error
