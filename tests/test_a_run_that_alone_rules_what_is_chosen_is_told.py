"""Of two or more runs that select, one may hold nearly all that is left: a choice goes by it."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.one_run import ruling_selecting_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED

SAMPLES = 1000


def found(*sizes, kind="unknown"):
    """Runs that leave noise of these sizes, of a floor of 1, by a model that says 0."""
    runs = []
    for k, size in enumerate(sizes):
        values = size * np.random.default_rng(k).standard_normal(SAMPLES)
        seen = Observation(values, 1.0, np.ones(SAMPLES, bool))
        runs.append(Replay(f"run {k}", "", 0.01 * np.arange(SAMPLES), {}, {"speed": seen}))
    predictor = Some(predict=lambda values, replays: {"speed": [np.zeros(SAMPLES)] * len(replays)})
    error = float(np.sqrt(np.mean(np.square(sizes))))
    model = Some(predictor=predictor, values={}, select_error=error, effects=())
    search = Some(verdict=Some(kind=kind), corrected=model, floor=1.0)
    return Some(search=search, limits=REPEATED, split=Some(select=runs))


def test_it_is_named_though_the_other_leaves_something_as_well():
    said = ruling_selecting_sentence(found(1.3, 4.5))
    # 19.25 of 19.94 squares above noise, 96.5 %; 1000 rows tell each to 5 %.
    assert "holds 96 %" in said or "holds 97 %" in said
    assert "run 1 (4." in said


@pytest.mark.parametrize("sizes", [(8.0,), (4.0, 8.0), (8.0, 8.0, 1.0), (1.0, 1.02)])
def test_of_one_run_or_where_others_hold_as_much_or_at_the_floor_none_is(sizes):
    assert ruling_selecting_sentence(found(*sizes)) == ""


def test_where_nothing_is_missing_none_is():
    assert ruling_selecting_sentence(found(1.0, 8.0, kind="nothing missing")) == ""
