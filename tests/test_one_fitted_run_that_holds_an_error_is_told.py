"""A hand that braked in one fitted run: its name, and when, though the selecting runs are right."""

from dataclasses import replace
from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.one_run import one_fitted_run_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED

SAMPLES = 1000


def found(*wrong, runs=3, kind="lack or noise", selecting=1.0):
    """Runs of noise of size 1, of which these are 8 off from 3 to 4 s; a model that says 0."""
    fitted = []
    for k in range(runs):
        values = np.random.default_rng(k).standard_normal(SAMPLES)
        values[300:400] += 8.0 if k in wrong else 0.0
        seen = Observation(values, 1.0, np.ones(SAMPLES, bool))
        fitted.append(
            Replay(f"run {k}", f"run {k}", 0.01 * np.arange(SAMPLES), {}, {"speed": seen})
        )
    predictor = Some(predict=lambda values, replays: {"speed": [np.zeros(SAMPLES)] * len(replays)})
    model = Some(predictor=predictor, values={}, select_error=selecting, effects=())
    search = Some(verdict=Some(kind=kind), corrected=model, floor=1.0)
    return Some(search=search, limits=REPEATED, fitted=fitted, floors=Floors(1.0, 1.0, 1.0))


def test_it_is_named_with_when_it_was():
    said = one_fitted_run_sentence(found(1))
    # 100 of 1000 rows are 8 off: sqrt(1 + 0.1 * 64) = 2.72, noise 0.03.
    assert "run 1 (2.7" in said
    assert "Did something else act in it" in said


@pytest.mark.parametrize(
    "other",
    [found(), found(0, 1), found(1, runs=2), found(1, kind="nothing missing"),
     found(1, selecting=2.0)],
)  # fmt: skip
def test_not_where_none_or_two_are_or_of_two_or_where_other_runs_show_it_too(other):
    assert one_fitted_run_sentence(other) == ""


SLIP = 8.0 * (np.arange(SAMPLES) // 100 == 3)


@pytest.mark.parametrize(("kinds", "hand"), [("11", False), ("12", True)])
def test_where_the_model_alone_slips_in_it_and_not_in_a_run_like_it_no_hand_is_meant(kinds, hand):
    said = one_fitted_run_sentence(of_kinds(kinds, rests=True, slips=("run 1",)))
    assert "run 1 (2.7" in said
    assert ("Did something else act" in said) is hand
    assert ("as run 2 does, a run of the same kind" in said) is not hand


def test_a_hand_that_moved_it_is_meant_where_the_run_like_it_rests():
    assert "Did something else act" in one_fitted_run_sentence(of_kinds("11", False, ()))


def of_kinds(kinds, rests, slips):
    """Runs 1 and 2 of these kinds; whether run 1 rests, in which runs the model slips."""
    one = found(1)
    for k, kind in zip((1, 2), kinds, strict=True):
        one.fitted[k] = replace(one.fitted[k], experiment=kind)
    if rests:
        seen = Observation(one.fitted[2].observed["speed"].values, 1.0, np.ones(SAMPLES, bool))
        one.fitted[1] = replace(one.fitted[1], observed={"speed": seen})

    def predict(values, replays):
        return {"speed": [SLIP if r.name in slips else np.zeros(SAMPLES) for r in replays]}

    one.search.corrected.predictor = Some(predict=predict)
    return one
