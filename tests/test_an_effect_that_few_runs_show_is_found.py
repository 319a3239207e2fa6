"""Runs that cannot show an effect dilute what the others show; the floor is only an estimate."""

from dataclasses import replace

import numpy as np
import pytest
from evidence import judged

from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Trial, share
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import errors_by_experiment
from simpter_hybrid.identification.tracing.rivals import LEAST_FURTHER, is_believed

FLOOR, BEFORE = 1.0, 1.004


def _trial(name, gain, local, parameters=1):
    own = tuple(Parameter(f"p{k}", 0.0, -1.0, 1.0, 0.1) for k in range(parameters))
    candidate = Candidate(name, own, ((0.0,) * parameters,), name, "load", ("x",))
    fit = Fit({}, 0.0, np.empty((0, 0)), np.empty(0))
    after = BEFORE * (1.0 - gain)
    return Trial(candidate, fit, after, gain, share(BEFORE, after, FLOOR), local)


@pytest.mark.parametrize(
    ("gain", "local", "kind"),
    [
        (0.012, 0.09, "effect"),
        (0.012, 0.04, "nothing missing"),
        (-0.001, 0.09, "nothing missing"),  # what these runs gain, others lose
        (0.023, 0.03, "effect"),
    ],
)
def test_it_is_believed_by_the_runs_of_one_experiment(gain, local, kind):
    ratio = BEFORE / FLOOR
    assert judged([_trial("drag", gain, local)], [], [], FLOOR, ratio=ratio).kind == kind


def test_one_short_experiment_is_not_enough():
    assert judged([_trial("drag", 1e-4, 0.5)], [], [], FLOOR, ratio=1.0).kind == "nothing missing"


def test_one_that_is_not_believed_does_not_hide_one_that_is():
    better, shown = _trial("better", 0.019, 0.04), _trial("shown", 0.012, 0.09)
    assert judged([better, shown], [], [], FLOOR).accepted.candidate.name == "shown"


def test_a_further_effect_must_show_in_all_runs():
    assert not is_believed(_trial("drag", 0.012, 0.2), LEAST_FURTHER)


def test_a_rival_must_explain_nearly_as_much():
    best, poor, good = (_trial("a", 0.012, 0.1), _trial("b", 0.005, 0.06), _trial("c", 0.011, 0.1))
    assert judged([best, poor], [], [], FLOOR).kind == "effect"
    assert [t.candidate.name for t in judged([best, good], [], [], FLOOR).rivals] == ["c"]


def test_a_form_with_fewer_numbers_that_explains_a_tenth_is_not_preferred():
    best, simple = _trial("rich", 0.012, 0.1, parameters=3), _trial("plain", 0.0095, 0.08)
    verdict = judged([best, simple], [], [], FLOOR)
    assert verdict.accepted.candidate.name == "rich"


def test_what_a_model_attains_is_noise_whatever_the_floor_was_thought_to_be():
    assert share(1.0, 0.98, 1.02) == pytest.approx(1.0)
    assert share(1.0, 1.01, 1.02) == 0.0
    assert share(1.5, 1.25, 1.0) == pytest.approx((1.5**2 - 1.25**2) / (1.5**2 - 1.0))


def test_errors_are_told_apart_by_experiment():
    def run(experiment, error):
        seen = Observation(np.full(50, error), 1.0, np.ones(50, bool))
        return Replay(experiment, experiment, np.arange(50.0), {}, {"y": seen})

    runs = [run("a", 1.0), run("b", 3.0), run("a", 1.0)]
    predictor = type("Zero", (), {"predict": lambda self, v, r: {"y": [np.zeros(50)] * len(r)}})()
    whole, apart = errors_by_experiment(predictor, {}, runs)
    assert apart == {"a": pytest.approx(1.0), "b": pytest.approx(3.0)}
    assert whole == pytest.approx(np.sqrt((1.0 + 9.0 + 1.0) / 3))
    assert errors_by_experiment(predictor, {}, [replace(runs[0], observed={})]) == (0.0, {})
