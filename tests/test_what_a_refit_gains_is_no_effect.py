"""A base that its own fit has left in a valley: what a candidate's fit gains is not its own."""

from dataclasses import replace

from toy_rig import ALONG_X, ToyRig, toy_replay, tracer

from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.fitted_model import Split, fitted_model
from simpter_hybrid.identification.tracing.rounds import search_effects


def _found(gain):
    """A search from a base whose scale is 1 where 1.2 is right."""
    runs = [toy_replay("run", k, scale=1.2, gain=gain, experiment="abc"[k % 3]) for k in range(6)]
    split = Split(runs[:2], runs[2:4], runs[4:])
    fitter = Fitter(ToyRig(), split.fit)
    stuck = fitter.fit({"scale": 1.0}, iterations=0)
    candidate = replace(ALONG_X, starts=((0.1,),))
    base = fitted_model(fitter, stuck, split, ())
    return search_effects(base, [candidate], split, tracer, floor=1.0), base


def test_an_effect_of_size_zero_is_not_named():
    found, stuck = _found(gain=0.0)
    assert found.verdict.kind == "nothing missing"
    assert found.refitted.select_error < 1.05 < stuck.select_error
    assert abs(found.corrected.values["scale"] - 1.2) < 0.01


def test_an_effect_that_is_there_is_named_beside_it():
    found, _ = _found(gain=0.3)
    assert [e.name for e in found.corrected.effects] == ["along x"]
    assert abs(found.corrected.values["gain"] - 0.3) < 0.02
