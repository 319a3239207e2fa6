"""Synthetic runs of the found model: an honest search names nothing, a careless one is caught."""

from types import SimpleNamespace

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.tracing.verdict import Verdict
from simpter_hybrid.identification.trials import false_alarms

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
    found = false_alarms(base, [ALONG_X, ALONG_Y], split, _nothing, _floors(1.0), count=5)
    assert (found.count, dict(found.named), found.unknown) == (5, {}, 0)


def test_a_search_that_believes_everything_is_caught(split, monkeypatch):
    monkeypatch.setattr(f"{TRACING}.round.LEAST_GAIN", -1.0)
    monkeypatch.setattr(f"{TRACING}.round.CLEAN", 0.0)
    monkeypatch.setattr(f"{TRACING}.rounds.HOPEFUL", -1.0)
    monkeypatch.setattr(f"{TRACING}.further.HOPEFUL", -1.0)
    monkeypatch.setattr(f"{TRACING}.verdict.LEAST_SHARE", -np.inf)
    base = refitted(ToyRig(), split)
    found = false_alarms(base, [ALONG_X, ALONG_Y], split, _nothing, _floors(0.9), count=3)
    assert sum(found.named.values()) == 3


def test_the_same_seed_gives_the_same_count(split):
    base = refitted(ToyRig(), split)
    one, two = (
        false_alarms(base, [ALONG_X], split, _nothing, _floors(1.0), 2, seed=7) for _ in range(2)
    )
    assert one == two


def test_each_part_of_a_set_is_judged_by_its_own_floor(split, monkeypatch):
    asked = []

    def searched(base, tried, null, tracer, floor, limit, fit_floor):
        asked.append((fit_floor, floor))
        return SimpleNamespace(verdict=Verdict("nothing missing"))

    monkeypatch.setattr("simpter_hybrid.identification.trials.search_effects", searched)
    base = refitted(ToyRig(), split)
    false_alarms(base, [ALONG_X], split, _nothing, _floors(5.0, fit=8.0), count=2)
    assert asked == [(8.0, 5.0)] * 2


def test_what_the_found_model_leaves_is_noise_of_its_own_sets(split):
    base = refitted(ToyRig(), split)
    found = false_alarms(base, [ALONG_X, ALONG_Y], split, _nothing, _floors(0.2), count=3)
    assert (dict(found.named), found.unknown) == ({}, 0)
