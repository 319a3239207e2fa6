"""A fit that stops where the error falls by next to nothing is off by what it has left to go."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.reporting.parameters import left_to_go

LINES = np.random.default_rng(1).normal(size=(50, 2))
BEST, TOLD = np.array([2.0, -1.0]), {"a": 1.9, "b": -0.8}
PARAMETERS = [Parameter(name, 0.0, -9.0, 9.0, 1.0) for name in TOLD]


def fitter(worse):
    def residuals(values):
        off = LINES @ (np.array([values["a"], values["b"]]) - BEST)
        return 9.0 + 0.0 * off if worse else off

    return SimpleNamespace(parameters=PARAMETERS, residuals=residuals)


@pytest.mark.parametrize(
    ("worse", "far"), [(False, {"a": 0.1, "b": 0.2}), (True, {"a": 0, "b": 0})]
)
def test_it_is_a_step_of_the_linear_model_if_that_lowers_the_error(worse, far):
    at = LINES @ (np.array(list(TOLD.values())) - BEST)
    fit = Fit(TOLD, float(at @ at), LINES, at)
    left = left_to_go(fitter(worse), fit, TOLD)
    assert left == pytest.approx(far, abs=1e-6)  # a ridge of 1e-9 in the step
