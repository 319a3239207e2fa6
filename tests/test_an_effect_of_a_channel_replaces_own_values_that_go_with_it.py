"""Own values that fall with a logged temperature: an effect by temperature is asked instead."""

from types import SimpleNamespace

import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification import channel_effects
from simpter_hybrid.identification.channel_effects import by_channel_instead
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.rigs.temperature import temperature_library
from simpter_hybrid.identification.run_levels import RunLevels
from simpter_hybrid.identification.tracing.limits import SINGLE
from simpter_hybrid.identification.tracing.rounds import SearchResult
from simpter_hybrid.identification.tracing.verdict import Verdict
from simpter_hybrid.identification.weighted_search import WeightedSearch, WeightedSearchResult

BY_TEMPERATURE = temperature_library(1, 1, 300.0, 20.0, 0.1)


def levels(channel):
    runs = tuple((f"run {k}", 1.2 - 0.05 * k) for k in range(7))
    order = dict(zip((name for name, _ in runs), (3, 1, 6, 0, 5, 2, 4), strict=True))
    warm = {name: float(k) for k, (name, _) in enumerate(runs)}
    logged = {"temperature": warm if channel == "temperature" else order, "pressure": warm}
    return RunLevels("friction", runs[::2] + runs[1::2], 9.0, 1.0, 0.95, logged)


def asked(monkeypatch, left, channel="temperature", tried=BY_TEMPERATURE):
    """What is found where such an effect leaves `left` times the floor, with common values."""
    runs = [toy_replay(str(k), k) for k in range(2)]
    split = Split(runs, runs, runs)
    model = refitted(ToyRig(), split)
    done = SearchResult(model, model, (), Verdict("unknown"), model.select_error)
    rest = None, runs, SINGLE, 1.0, Floors(1.0, 1.0, 1.0)
    found = WeightedSearchResult(done, split, *rest)
    bench = SimpleNamespace(predictor=ToyRig())
    search = WeightedSearch(bench, tried, {}, {}, lambda text: None)
    made = SimpleNamespace(corrected=SimpleNamespace(select_error=left * model.select_error))
    monkeypatch.setattr(channel_effects, "gone_on_with", lambda *args: made)
    again = by_channel_instead(search, found, (levels(channel),))
    return again is not None and again.search is made


@pytest.mark.parametrize(("left", "kept"), [(1.04, True), (1.06, False)])
def test_it_is_kept_if_it_leaves_about_as_little(monkeypatch, left, kept):
    assert asked(monkeypatch, left) is kept


def test_not_where_the_values_go_with_another_channel(monkeypatch):
    assert not asked(monkeypatch, 1.0, channel="pressure")


def test_nor_where_no_effect_follows_the_channel(monkeypatch):
    assert not asked(monkeypatch, 1.0, tried=())
