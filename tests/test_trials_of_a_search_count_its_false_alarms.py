"""Synthetic runs of the found model: an honest search names nothing, a careless one is caught."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.signal import lfilter
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.false_alarms import _noisy, count_false_alarms
from simpter_hybrid.identification.fitting.effort import Effort
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.fitting.replay import Observation
from simpter_hybrid.identification.fitting.residual import deviation, rms
from simpter_hybrid.identification.reporting.sentences import trials_sentence
from simpter_hybrid.identification.tracing.verdict import Verdict

TRACING = "simpter_hybrid.identification.tracing"


def _floors(select, fit=None):
    return Floors(select if fit is None else fit, select, select)


def _nothing(predictor, values, replays):
    return {}


@pytest.fixture
def split():
    runs = [toy_replay("run", k, scale=1.1, experiment="abc"[k % 3]) for k in (1, 2, 4, 5)]
    return Split(runs[:2], runs[2:], ())


def test_an_honest_search_names_nothing(split):
    base = refitted(ToyRig(), split)
    found = count_false_alarms(base, [ALONG_X, ALONG_Y], split, _nothing, _floors(1.0), count=5)
    assert (found.count, dict(found.named), found.unknown) == (5, {}, 0)


def test_a_search_that_believes_everything_is_caught(split, monkeypatch):
    monkeypatch.setattr(f"{TRACING}.round.LEAST_GAIN", -1.0)
    monkeypatch.setattr(f"{TRACING}.round.CLEAN", 0.0)
    monkeypatch.setattr(f"{TRACING}.rounds.HOPEFUL", -1.0)
    monkeypatch.setattr(f"{TRACING}.further.HOPEFUL", -1.0)
    monkeypatch.setattr(f"{TRACING}.verdict.LEAST_SHARE", -np.inf)
    base = refitted(ToyRig(), split)
    found = count_false_alarms(base, [ALONG_X, ALONG_Y], split, _nothing, _floors(0.9), count=3)
    assert sum(found.named.values()) == 3


def test_the_same_seed_gives_the_same_count(split):
    base = refitted(ToyRig(), split)
    one, two = (
        count_false_alarms(base, [ALONG_X], split, _nothing, _floors(1.0), 2, seed=7)
        for _ in range(2)
    )
    assert one == two


def test_each_part_of_a_set_is_judged_by_its_own_floor(split, monkeypatch):
    asked = []

    def searched(base, tried, null, tracer, floor, limit, fit_floor):
        asked.append((fit_floor, floor))
        return SimpleNamespace(verdict=Verdict("nothing missing"))

    monkeypatch.setattr("simpter_hybrid.identification.false_alarms.search_effects", searched)
    base = refitted(ToyRig(), split)
    count_false_alarms(base, [ALONG_X], split, _nothing, _floors(5.0, fit=8.0), count=2)
    assert asked == [(8.0, 5.0)] * 2


def test_what_the_found_model_leaves_is_noise_of_its_own_sets(split):
    base = refitted(ToyRig(), split)
    found = count_false_alarms(base, [ALONG_X, ALONG_Y], split, _nothing, _floors(0.2), count=3)
    assert (dict(found.named), found.unknown) == ({}, 0)


@pytest.mark.parametrize("windows", [(), (0, 250, 500, 750)])
@pytest.mark.parametrize("every", [1, 4])
def test_noise_of_a_set_is_as_large_as_what_was_left_where_rows_are_compared(windows, every):
    left = 0.1 * np.random.default_rng(1).standard_normal(1000)
    for k, at in enumerate(windows):  # the line that a window's start leaves
        left[at : at + 250] += 0.5 * k + np.linspace(0.0, (-1) ** k, 250)
    keep = np.arange(1000) % every == 0
    seen = Observation(left, 0.1, keep, windows=windows)
    nothing = np.zeros(1000)
    made = [_noisy(seen, nothing, np.random.default_rng(k)) for k in range(50)]
    noise = [rms(deviation(replace(seen, values=values), nothing)) for values in made]
    # A mean of 50, each as sure as a 1 / sqrt(2 * 250) of it: 0.7 %; three of them.
    assert np.mean(noise) == pytest.approx(rms(deviation(seen, nothing)), rel=0.021)


def test_a_set_may_take_as_many_steps_as_it_is_told(split, monkeypatch):
    given = []

    def searched(base, *_args, **_more):
        given.append(base.predictor.effort.most - base.predictor.effort.spent)
        base.predictor.effort.add(30.0)
        return SimpleNamespace(verdict=Verdict("nothing missing"))

    class Counting(ToyRig):
        effort = Effort()

    monkeypatch.setattr("simpter_hybrid.identification.false_alarms.search_effects", searched)
    base = refitted(Counting(), split)
    count_false_alarms(base, [ALONG_X], split, _nothing, _floors(1.0), count=2, effort=100.0)
    assert given == [100.0, 100.0]
    assert Counting.effort.most == np.inf


def test_what_cannot_be_told_from_noise_is_no_lack_that_was_told_of(split, monkeypatch):
    kinds = iter(["unknown", "lack or noise", "nothing missing", "lack or noise"])

    def searched(*_args, **_more):
        return SimpleNamespace(verdict=Verdict(next(kinds)))

    monkeypatch.setattr("simpter_hybrid.identification.false_alarms.search_effects", searched)
    base = refitted(ToyRig(), split)
    found = count_false_alarms(base, [ALONG_X], split, _nothing, _floors(1.0), count=4)
    assert (found.unknown, found.untold) == (1, 2)
    told = trials_sentence(found)
    assert "told of a lack that none explains 1 times, and said 2 times that it cannot" in told
    assert "cannot be told" not in trials_sentence(replace(found, untold=0))


def test_it_keeps_its_colour_where_rows_are_not_compared():
    def correlation(noise, keep):
        return np.corrcoef(noise[keep][1:], noise[keep][:-1])[0, 1]

    left = lfilter([1.0], [1.0, -0.9], np.random.default_rng(1).standard_normal(4000))
    keep = np.arange(4000) % 4 == 0
    seen = Observation(left, 1.0, keep)
    made = [_noisy(seen, np.zeros(4000), np.random.default_rng(k)) for k in range(20)]
    # 0.9^4 = 0.656; 1000 rows tell a correlation to 0.03.
    assert correlation(left, keep) == pytest.approx(0.656, abs=0.1)
    found = np.mean([correlation(noise, keep) for noise in made])
    assert found == pytest.approx(correlation(left, keep), abs=0.03)


def test_of_a_window_of_which_hardly_a_row_is_compared_no_noise_is_drawn():
    keep = np.arange(100) < 3
    seen = Observation(np.random.default_rng(1).standard_normal(100), 1.0, keep, windows=(0,))
    assert np.array_equal(_noisy(seen, np.ones(100), np.random.default_rng(1)), np.ones(100))


def test_a_set_whose_search_was_cut_short_is_counted(split, monkeypatch):
    class Counting(ToyRig):
        effort = Effort()

    def searched(base, *_args, **_more):
        base.predictor.effort.add(30.0)
        return SimpleNamespace(verdict=Verdict("nothing missing"))

    monkeypatch.setattr("simpter_hybrid.identification.false_alarms.search_effects", searched)
    base = refitted(Counting(), split)
    found = count_false_alarms(base, [ALONG_X], split, _nothing, _floors(1.0), count=3, effort=20.0)
    assert found.cut_short == 3
    assert "(3 of them were cut short: `--effort`)" in trials_sentence(found)
