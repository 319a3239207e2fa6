"""From far off the column of a scale says little, and what it asks for is beyond any bound."""

from dataclasses import dataclass

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.fit import FURTHEST, Fitter, bounded_step
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay

TIME = np.linspace(0.0, 50.0, 200)
TRUE = {"level": 1.0, "change": 0.25, "scale": 8.0}


@dataclass(frozen=True)
class Settling:
    """A level that settles, slowly or at once."""

    parameters: tuple[Parameter, ...] = (
        Parameter("level", 1.1, 0.1, 9.0, 0.02),
        Parameter("change", 0.0, -0.8, 1.0, 0.03),
        Parameter("scale", 30.0, 0.02, 3000.0, 0.08),
    )

    def predict(self, values, replays):
        settled = values["change"] * np.exp(-TIME / values["scale"])
        return {"row": [values["level"] * (1.0 + settled) for _ in replays]}


@pytest.fixture
def fitter():
    (course,) = Settling().predict(TRUE, [None])["row"]
    seen = Observation(course, 0.01, np.ones(TIME.size, bool))
    return Fitter(Settling(), [Replay("1", "a", TIME, {}, {"row": seen})])


@pytest.mark.parametrize("scale", [0.5, 40.0, 400.0])
def test_it_is_found(fitter, scale):
    found = fitter.fit({"level": 1.1, "change": 0.05, "scale": scale}, iterations=30)
    assert found.values == pytest.approx(TRUE, rel=0.02)  # typical sizes over these values


def test_one_step_takes_it_by_a_limited_factor(fitter):
    start = {"level": 1.1, "change": 0.05, "scale": 400.0}
    at = fitter.residuals(start)
    step = bounded_step(fitter.parameters, start, fitter.jacobian(start, at), at, 1e-4)
    assert 400.0 / FURTHEST <= step["scale"] <= 400.0 * FURTHEST
