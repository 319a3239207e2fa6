"""One run with another friction draws a common fit to itself: most runs outvote it."""

from types import SimpleNamespace as Some

import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification import runwise_search
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.own_refits import at_medians
from simpter_hybrid.identification.own_values import run_levels


def found_in(scales):
    runs = [toy_replay(str(k), k, scale=s) for k, s in enumerate(scales)]
    split = Split(runs[:-1], runs[-1:], runs)
    return Some(split=split, search=Some(refitted=refitted(ToyRig(), split)), noise=1.0)


def test_the_typical_model_has_what_most_runs_ask_for():
    found = found_in((1.0, 1.02, 1.45, 0.98))
    # The common fit lies between; what most share is known to 0.002 a run.
    assert found.search.refitted.values["scale"] > 1.1
    (typical,) = runwise_search._typical(Some(say=print), found)
    assert typical.values["scale"] == pytest.approx(1.01, abs=0.006)


def test_of_two_runs_neither_is_odd():
    assert runwise_search._typical(Some(say=print), found_in((1.0, 1.4))) == []


def test_own_values_are_begun_where_they_were():
    found = found_in((1.0, 1.02, 1.45, 0.98))
    runs = [*found.split.fit, *found.split.select]
    first = run_levels(found.search.refitted, runs, 1.0)
    again = run_levels(found.search.refitted, runs, 1.0, ("scale",), first)
    scale = next(p for p in ToyRig().parameters if p.name == "scale")
    # Linear in the scale: begun at the least, a fit stays there.
    assert again.values(scale) == pytest.approx(first.values(scale), rel=1e-4)
    assert first.values(scale) == pytest.approx(
        {"0": 1.0, "1": 1.02, "2": 1.45, "3": 0.98}, abs=0.01
    )


def test_common_values_of_what_differs_begin_at_the_median():
    found = found_in((1.0, 1.02, 1.45, 0.98))
    model = found.search.refitted
    own = (run_levels(model, [*found.split.fit, *found.split.select], 1.0),)
    assert at_medians(model, own)["scale"] == pytest.approx(1.01, abs=0.006)
