"""Where one run alone holds what those that select leave, a reader is told which, and when."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.one_run import one_run_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED

SAMPLES = 1000


def found(*wrong, runs=6, kind="form incomplete", effects=("stribeck",)):
    """Runs of noise of size 1, of which these are 4 off from 3 to 4 s; a model that says 0."""
    replays = []
    for k in range(runs):
        values = np.random.default_rng(k).standard_normal(SAMPLES)
        if k in wrong:
            values[300:400] += 4.0
        seen = Observation(values, 1.0, np.ones(SAMPLES, bool))
        time = 0.01 * np.arange(SAMPLES)
        replays.append(Replay(f"run {k}", "sweep", time, {}, {"speed": seen}))
    zero = {"speed": [np.zeros(SAMPLES)] * runs}
    every = np.concatenate([r.observed["speed"].values for r in replays])
    error = float(np.sqrt(np.mean(every**2)))
    predictor = Some(predict=lambda values, replays: zero)
    model = Some(predictor=predictor, values={}, select_error=error, effects=effects)
    search = Some(verdict=Some(kind=kind), corrected=model, floor=1.0)
    return Some(search=search, limits=REPEATED, split=Some(select=replays))


def test_it_is_named_with_when_it_was():
    said = one_run_sentence(found(2))
    # 100 of 1000 rows are 4 off: sqrt(1 + 0.1 * 16) = 1.61, noise 0.03; half a second either way.
    assert "run 2 (1.6" in said
    assert "most of it from 2" in said or "most of it from 3" in said


@pytest.mark.parametrize("wrong", [(), (1, 4)])
def test_where_none_or_two_are_off_nothing_is_said(wrong):
    assert one_run_sentence(found(*wrong)) == ""


def test_of_few_runs_none_is_an_exception():
    assert one_run_sentence(found(2, runs=4)) == ""


def test_where_nothing_is_missing_nothing_is_said():
    assert one_run_sentence(found(2, kind="nothing missing", effects=())) == ""
