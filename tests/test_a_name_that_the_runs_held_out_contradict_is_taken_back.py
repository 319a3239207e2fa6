"""They are opened once, when all is decided: they choose nothing, and may say no."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.carried_over import WORSE, contradicted, seen_held_out
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.lack_sentences import lack_sentence
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.run_levels import RunLevels
from simpter_hybrid.identification.stage_errors import StageErrors
from simpter_hybrid.identification.tracing.limits import REPEATED, SIMULATED, SINGLE
from simpter_hybrid.identification.tracing.rounds import SearchResult
from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.identification.tracing.verdict import Verdict

FLOORS = Floors(1.0, 1.0, 1.0)
WAVE = SimpleNamespace(name="surface-wave", coordinates=("force:speed",))


def _dependence(gain):
    return Dependence("speed", gain, 0.001, 1000, *(3 * [[0.0]]))


def _done(refitted, gain=0.0):
    """A search that named a wave; what the refitted model leaves depends on the speed by `gain`."""
    model = SimpleNamespace(select_error=refitted, effects=(), residuals=np.zeros(0))
    other = SimpleNamespace(select_error=1.0, effects=(WAVE,), residuals=np.zeros(0))
    verdict = Verdict("effect", SimpleNamespace(candidate=WAVE))
    rounds = (SimpleNamespace(before={"force": (_dependence(gain),)}),)
    return SearchResult(model, other, rounds, verdict, 1.0)


@pytest.mark.parametrize("times", [0.5, 1.0, WORSE])
def test_what_predicts_them_as_well_stays(times):
    done = _done(1.3)
    ladder = {"declared": 3.0, "refitted": 1.3, "after": times * 1.3}
    assert contradicted(done, ladder, FLOORS, SINGLE) == (done, None)


@pytest.mark.parametrize(
    ("left", "limit", "told"),
    [(1.04, REPEATED, "effect"), (1.12, REPEATED, "form incomplete"), (1.12, SINGLE, "effect"),
     (float("nan"), REPEATED, "effect")],
)  # fmt: skip
def test_what_leaves_more_on_them_than_right_forms_do_is_incomplete(left, limit, told):
    done, ladder = _done(1.3), {"declared": 9.0, "refitted": 2.0, "after": left}
    assert seen_held_out(done, ladder, FLOORS, limit).verdict.kind == told
    far = [RunLevels("f", (("a", 0.8), ("b", 1.2)), 1.0, 0.1, 0.9)]
    assert seen_held_out(done, ladder, FLOORS, limit, far) is done
    as_set = replace(done, verdict=replace(done.verdict, kind="cannot be told apart"))
    assert seen_held_out(as_set, ladder, FLOORS, limit) is as_set


@pytest.mark.parametrize(
    ("ratio", "declared", "refitted", "limit", "clear"),
    [(1.0, 2.0, 1.055, REPEATED, True), (1.0, 2.0, 1.07, REPEATED, False),
     (1.0, 1.05, 1.3, REPEATED, True),  # a refit that does not carry over is no lack
     (1.2, 2.0, 1.19, SIMULATED, True), (1.2, 2.0, 1.21, SIMULATED, False),
     (1.0, 2.0, 1.45, SINGLE, True)],
)  # fmt: skip
def test_an_all_clear_that_they_do_not_show_is_none(ratio, declared, refitted, limit, clear):
    model = SimpleNamespace(select_error=ratio, effects=(), residuals=np.zeros(0))
    done = SearchResult(model, model, (), Verdict("nothing missing"), 1.0)
    ladder = {"declared": declared, "refitted": refitted, "after": refitted}
    kind = seen_held_out(done, ladder, FLOORS, limit).verdict.kind
    assert kind == ("nothing missing" if clear else "lack or noise")


@pytest.mark.parametrize("known", [(0.9, 1.4), (1.4, 0.9)])
@pytest.mark.parametrize(
    ("refitted", "gain", "kind"),
    [(1.3, 0.0, "nothing missing"), (1.3, 0.3, "lack or noise"), (4.0, 0.3, "lack or noise")],
)
def test_what_they_contradict_is_not_named(known, refitted, gain, kind):
    done = _done(refitted, gain)
    found, back = contradicted(
        done, {"declared": known[0], "refitted": known[1], "after": 1.3}, FLOORS, SINGLE
    )
    assert found.corrected is done.refitted
    assert (found.verdict.kind, found.verdict.accepted) == (kind, None)
    assert back.names == ("surface-wave",)
    assert (back.select, back.held_out) == ((refitted, 1.0), (min(known), 1.3))


@pytest.mark.parametrize(("fitted", "kind"), [(1.4, "nothing missing"), (3.0, "lack or noise")])
def test_fitted_runs_that_are_far_off_count_as_in_the_search(fitted, kind):
    done = _done(1.3)
    done.refitted.residuals = np.full(4, fitted)
    ladder = {"declared": 1.4, "refitted": 1.4, "after": 1.5}
    found, back = contradicted(done, ladder, FLOORS, SINGLE)
    assert found.verdict.kind == kind
    told = SimpleNamespace(
        search=found, taken_back=back, limits=SINGLE, floors=FLOORS, recording=None,
        error_by_stage=ladder,
    )  # fmt: skip
    alone = "On the fitted runs the refitted model leaves 3.00 times the floor"
    assert (alone in lack_sentence(told)) is (fitted == 3.0)


def test_where_they_show_more_than_the_others_it_cannot_be_told():
    ladder = {"declared": 1.9, "refitted": 3.0, "after": 2.5}
    found, _ = contradicted(_done(1.1), ladder, FLOORS, SINGLE)
    assert found.verdict.kind == "lack or noise"


def test_where_they_too_show_a_lack_it_is_unknown_and_the_sentence_has_the_numbers():
    done = _done(4.0, 0.3)
    found, back = contradicted(
        done, {"declared": 5.0, "refitted": 3.0, "after": 3.6}, FLOORS, SINGLE
    )
    assert found.verdict.kind == "unknown"
    assert found.verdict.coordinates == ("force:speed",)
    told = SimpleNamespace(
        search=found, taken_back=back, limits=SINGLE, floors=FLOORS, recording=None
    )  # fmt: skip
    assert lack_sentence(told) == (
        "Something is missing and none of the known effects explains it: surface-wave lowers the "
        "error of the runs that select from 4.00 to 1.00 times the floor, but those held out have "
        "3.60 with it and 3.00 without: it is not named. By the runs that fit and select it "
        "depends on speed."
    )


def test_what_an_effect_more_than_halved_is_no_noise_though_it_depends_on_nothing():
    done = _done(4.0)
    found, back = contradicted(
        done, {"declared": 5.0, "refitted": 3.0, "after": 3.6}, FLOORS, SINGLE
    )
    assert (found.verdict.kind, found.verdict.coordinates) == ("unknown", ())
    told = SimpleNamespace(
        search=found, taken_back=back, limits=SINGLE, floors=FLOORS, recording=None
    )  # fmt: skip
    assert lack_sentence(told).startswith("Something is missing and none of the known effects")
    assert "depends" not in lack_sentence(told)


@pytest.mark.parametrize(("apart", "taken"), [(0.02, True), (0.3, False)])
def test_runs_that_differ_much_say_nothing_of_what_else_is_there(apart, taken):
    own = RunLevels("mass", (("a", 1.0 - apart), ("b", 1.0 + apart)), 3.0, 1.0, 0.9)
    ladder = {"declared": 5.0, "refitted": 3.0, "after": 3.6}
    _, back = contradicted(_done(4.0), ladder, FLOORS, SINGLE, [own])
    assert (back is not None) is taken


def test_beside_what_differs_from_run_to_run_the_numbers_are_told_all_the_same():
    found, back = contradicted(
        _done(4.0, 0.3), {"declared": 5.0, "refitted": 3.0, "after": 3.6}, FLOORS, SINGLE
    )
    own = RunLevels("mass", (("a", 0.98), ("b", 1.02)), 3.0, 1.0, 0.9)
    told = SimpleNamespace(
        search=found, taken_back=back, limits=SINGLE, floors=FLOORS, levels=(own,)
    )
    said = verdict_sentence(told)
    assert "3.60 with it and 3.00 without: it is not named" in said
    assert "Beside that mass differs from run to run" in said


def test_of_what_is_taken_back_no_error_is_told_and_no_curve_over_what_it_left():
    stages = {"declared": 3.0, "refitted": 2.0, "after": 2.5, "empirical": 1.0, "floor": 1.0}
    kept = {"declared": 3.0, "refitted": 2.0, "after": 2.0, "floor": 1.0}
    told = StageErrors(stages, stages, stages, stages)
    assert told.without_after() == StageErrors(kept, kept, kept, kept)
