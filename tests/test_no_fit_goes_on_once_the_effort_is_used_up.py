"""What may be simulated bounds a fit at its next step, and no fit is carried on beyond."""

import numpy as np

from simpter_hybrid.identification.fitting.effort import Effort
from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay

TIME = np.arange(9.0)
RUN = Replay(
    "run", "run", TIME, {}, {"y": Observation(np.exp(-0.9 * TIME), 0.1, TIME >= 0.0, lines=False)}
)


class Counted:
    """One number, of which every simulation takes a step."""

    parameters = (Parameter("rate", 0.2, 0.0, 9.0, 0.1),)

    def __init__(self, most):
        self.effort = Effort(most)

    def predict(self, values, replays):
        self.effort.add(1.0)
        return {"y": [np.exp(-values["rate"] * r.time) for r in replays]}


def _fitted(most):
    predictor = Counted(most)
    fit = Fitter(predictor, [RUN]).fit({"rate": 0.2})
    return fit, predictor.effort.spent


def test_a_fit_without_a_bound_goes_to_its_end():
    fit, spent = _fitted(np.inf)
    assert abs(fit.values["rate"] - 0.9) < 1e-3
    assert spent > 6.0


def test_one_with_a_bound_ends_at_the_step_that_passes_it():
    fit, spent = _fitted(3.0)
    assert spent == 4.0
    assert fit.cost <= _fitted(0.0)[0].cost


def test_columns_are_not_computed_anew_beyond_it():
    for most in range(2, 12):
        assert _fitted(float(most))[1] <= most + 1.0
