"""What early rows do bends all later ones: columns that steps have corrected stop too early."""

from dataclasses import dataclass

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay, Restart

TIME = np.linspace(0.0, 3.0, 40)


@dataclass(frozen=True)
class Swing:
    """A decaying oscillation."""

    parameters: tuple[Parameter, ...] = (
        Parameter("rate", 0.5, 0.0, 9.0, 0.01),
        Parameter("pace", 6.0, 0.0, 9.0, 0.01),
    )

    def predict(self, values, replays):
        course = np.exp(-values["rate"] * TIME) * np.cos(values["pace"] * TIME)
        return {"row": [course for _ in replays]}


def off_its_columns(followed):
    """How far the Jacobian of a fit's end is from the one computed there, of its size."""
    noise = 0.3 * np.random.default_rng(4).standard_normal(TIME.size)
    (true,) = Swing().predict({"rate": 0.3, "pace": 5.6}, [None])["row"]
    seen = Observation(true + noise, 0.1, np.ones(TIME.size, bool))
    anew = (Restart(1, 0.0, 0.0),) if followed else ()
    fitter = Fitter(Swing(), [Replay("1", "a", TIME, {}, {"row": seen}, followed=anew)])
    fit = fitter.fit({"rate": 0.5, "pace": 6.0}, iterations=30, enough=1e-3)
    there = fitter.jacobian(fit.values, fit.residuals)
    return np.linalg.norm(fit.jacobian - there) / np.linalg.norm(there)


def test_the_end_of_one_followed_whole_was_asked_anew():
    assert off_its_columns(followed=True) == pytest.approx(0.0, abs=1e-12)  # the same differences


def test_windows_are_content_with_what_steps_have_told():
    assert off_its_columns(followed=False) > 0.01
