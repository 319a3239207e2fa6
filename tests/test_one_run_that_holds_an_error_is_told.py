"""Where one run alone holds what those that select leave, a reader is told which, and when."""

import re
from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.one_run import alone_when, one_run_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED

SAMPLES = 1000


def found(*wrong, runs=6, kind="form incomplete", effects=("stribeck",), alone=False, off=4.0):
    """Runs of noise of size 1, of which these are 4 off from 3 to 4 s; a model that says 0.

    Of two kinds in turn, each of which was fitted as well; `alone`: each of a kind of its own.
    """
    made = {}
    for part, seeds in (("fit", range(100, 102)), ("select", range(runs))):
        made[part] = []
        for k in seeds:
            values = np.random.default_rng(k).standard_normal(SAMPLES)
            if part == "select" and k in wrong:
                values[300:400] += off if k == wrong[0] else 4.0
            seen = Observation(values, 1.0, np.ones(SAMPLES, bool))
            time, sort = 0.01 * np.arange(SAMPLES), f"sweep {k if alone else k % 2}"
            made[part].append(Replay(f"run {k}", sort, time, {}, {"speed": seen}))
    every = np.concatenate([r.observed["speed"].values for r in made["select"]])
    error = float(np.sqrt(np.mean(every**2)))
    predictor = Some(predict=lambda values, replays: {"speed": [np.zeros(SAMPLES)] * len(replays)})
    model = Some(predictor=predictor, values={}, select_error=error, effects=effects)
    search = Some(verdict=Some(kind=kind), corrected=model, floor=1.0)
    split = Some(select=made["select"])
    return Some(search=search, limits=REPEATED, split=split, fitted=made["fit"])


def test_it_is_named_with_when_it_was():
    said = one_run_sentence(found(2))
    # 100 of 1000 rows are 4 off: sqrt(1 + 0.1 * 16) = 1.61, noise 0.03.
    assert "run 2 (1.6" in said
    begin, end = map(float, re.findall(r"from ([\d.]+) to ([\d.]+) s", said)[0])
    # A tenth of 1600 comes in a tenth of the second; noise of 1000 rows adds up to 45 either way.
    assert begin == pytest.approx(3.1, abs=0.1)
    assert end == pytest.approx(3.9, abs=0.1)


@pytest.mark.parametrize("wrong", [(), (1, 4)])
def test_where_none_or_two_are_off_nothing_is_said(wrong):
    assert one_run_sentence(found(*wrong)) == ""


def test_where_another_is_off_by_less_it_is_not_alone():
    assert one_run_sentence(found(3, 5, off=8.0)) == ""


def test_of_the_only_run_of_its_kind_it_may_be_a_lack():
    assert one_run_sentence(found(2, alone=True)) == ""


def test_of_few_runs_none_is_an_exception():
    assert one_run_sentence(found(2, runs=4)) == ""


def test_where_nothing_is_missing_nothing_is_said():
    assert one_run_sentence(found(2, kind="nothing missing", effects=())) == ""


def test_of_few_it_is_told_where_the_fitted_runs_hardly_show_it():
    one, two = (alone_when(found(*wrong, runs=3, effects=(), off=12.0)) for wrong in ((1,), (0, 1)))
    name, begin, end = re.fullmatch(
        r"(run \d), most of it from ([\d.]+) to ([\d.]+) s", one
    ).groups()
    assert name == "run 1"
    assert 3.0 <= float(begin) < float(end) <= 4.0
    assert two == ""
