"""The whole search on a rig small enough to know the answer."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay, tracer

from simpter_hybrid.identification.fitting.fitted_model import Split, Trial, refitted
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.identifiability_report import sight
from simpter_hybrid.identification.next_search import begun
from simpter_hybrid.identification.reporting.sight_sentences import in_classes
from simpter_hybrid.identification.tracing.rounds import search_effects
from simpter_hybrid.identification.tracing.verdict import Verdict


def _search(gain, candidates, second=0.0):
    def run(seed):
        replay = toy_replay("run", seed, scale=1.1, gain=gain, experiment="abc"[seed % 3])
        values = replay.observed["torque"].values
        values += second * replay.inputs["y"]
        return replay

    split = Split([run(1), run(2)], [run(4), run(5)], [run(7)])
    declared = refitted(ToyRig(), split)
    return search_effects(declared, candidates, split, tracer, floor=1.0)


ALONG_BOTH = replace(
    ALONG_X, name="along both", parameters=(*ALONG_X.parameters, *ALONG_Y.parameters),
    starts=((0.1, 0.1),), simpler="along x", further=True,
)  # fmt: skip


def test_nothing_missing():
    found = _search(0.0, [ALONG_X, ALONG_Y])
    assert found.verdict.kind == "nothing missing"
    assert found.corrected is found.refitted


def test_one_effect_is_named_and_its_size_found():
    found = _search(0.3, [ALONG_Y, ALONG_X])
    assert found.verdict.kind == "effect"
    assert [e.name for e in found.corrected.effects] == ["along x"]
    # Standard error of the gain: 0.1 / sqrt(4000 / 2) = 0.0022; four of them.
    assert found.corrected.values["gain"] == pytest.approx(0.3, abs=0.009)
    assert len(found.rounds) == 1


def test_two_effects_are_both_named():
    found = _search(0.3, [ALONG_Y, ALONG_X], second=0.15)
    assert [e.name for e in found.corrected.effects] == ["along x", "along y"]
    assert found.corrected.values["other"] == pytest.approx(0.15, abs=0.009)


@pytest.mark.parametrize(("second", "tried"), [(0.0, False), (0.15, True)])
def test_a_further_form_is_tried_where_the_best_of_its_family_is_not_enough(second, tried):
    found = _search(0.3, [ALONG_X, ALONG_BOTH], second)
    assert ("along both" in {t.candidate.name for t in found.rounds[0].trials}) is tried
    assert [e.name for e in found.corrected.effects] == ["along both" if tried else "along x"]
    assert found.corrected.select_error < 1.02


def test_a_search_that_begins_anew_tries_a_further_form_once():
    first = _search(0.3, [ALONG_X, ALONG_BOTH], 0.15)
    again = _search(0.3, begun([ALONG_X, ALONG_BOTH], first), 0.15)
    names = [t.candidate.name for t in again.rounds[0].trials]
    assert sorted(names) == ["along both", "along x"]


def test_lists_know_a_further_form_by_its_simplest():
    assert not ALONG_BOTH.listed
    assert ALONG_BOTH.listed_as == "along x"
    every = [ALONG_X, ALONG_BOTH, *(replace(ALONG_X, name=f"other {k}") for k in range(9))]
    blind = [c.name for c in every if c.listed]
    assert in_classes(blind, every) == ["every friction effect"]


def test_what_contests_a_further_form_is_asked_of_its_simplest():
    rival = replace(ALONG_X, name="rival", family="r")
    split = Split([toy_replay("run", 1)], [toy_replay("run", 2, experiment="b")], [])
    trials = [Trial(c, None, 1.0, 0.5, 1.0) for c in (ALONG_BOTH, rival)]
    contested = Verdict("cannot be told apart", trials[0], (trials[1],))
    every = [ALONG_X, ALONG_BOTH, rival]
    seen = sight(refitted(ToyRig(), split), every, split.select, (), [contested])
    assert ("along x", "rival") in seen.run_next


def test_an_effect_that_is_in_nobodys_list_is_unknown_with_its_variable():
    found = _search(0.3, [ALONG_Y])
    assert found.verdict.kind == "unknown"
    assert found.verdict.coordinates == ("friction:x",)
    assert found.corrected is found.refitted
    assert np.isclose(found.floor, 1.0)


def test_what_only_fitted_runs_show_is_not_nothing():
    """The selecting runs hold no motion in which the effect would act."""
    fit = [toy_replay("run", 1, gain=0.3), toy_replay("run", 2, gain=0.3, experiment="b")]
    select = [toy_replay("run", 4, experiment="c")]
    for replay in select:
        replay.inputs["x"][:] = 0.0
    split = Split(fit, select, [])
    declared = refitted(ToyRig(), split)
    found = search_effects(declared, [ALONG_X], split, tracer, floor=1.0)
    assert found.refitted.select_error < 1.05
    assert found.verdict.kind == "unknown"


def test_what_does_not_help_where_it_was_fitted_is_not_believed():
    """The selecting run happens to hold what no fitted run does."""
    fit = [toy_replay("run", 1), toy_replay("run", 2, experiment="b")]
    split = Split(fit, [toy_replay("run", 4, gain=0.3, experiment="c")], [])
    declared = refitted(ToyRig(), split)
    lucky = replace(ALONG_X, parameters=(Parameter("gain", 0.3, 0.3, 0.3, 0.05),), starts=((0.3,),))
    found = search_effects(declared, [lucky], split, tracer, floor=1.0)
    assert found.rounds[0].trials[0].gain > 0.5
    assert found.corrected.effects == ()
