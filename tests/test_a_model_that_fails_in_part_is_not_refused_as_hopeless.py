"""Of a model that cannot be simulated to the end no error over that of rest is known."""

from types import SimpleNamespace as Some

import numpy as np

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.hopeless import refuse_hopeless

TIME = 0.01 * np.arange(100)


def test_that_is_no_model_of_something_else():
    moved = np.sin(3.0 * TIME)
    seen = Observation(moved, 1e-3, np.ones(100, bool), lines=False)
    run = Replay("a", "a", TIME, {}, {"speed": seen})
    predicted = {"speed": [np.where(TIME < 0.9, moved, np.nan)]}
    predictor = Some(predict=lambda values, runs: predicted, declared=Some(device=Some(), loads=()))
    bench = Some(predictor=predictor, candidates=())
    refuse_hopeless(bench, Some(), {}, {}, {"fit": [run], "select": [run]})
