"""A hand that braked in one fitted run: its name, and when, though the selecting runs are right."""

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
