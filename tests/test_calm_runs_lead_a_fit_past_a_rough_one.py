"""One run whose error is a staircase holds up a fit; the runs beside it show the way."""

from dataclasses import dataclass

import numpy as np
import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.calm_runs import led_by_calm_runs
from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.predictor import Parameter

TRUE, TURNS = 1.3, 600.0
#: Where a rough run is as it was measured, some stairs down.
BESIDE = TRUE - 28 * 2 * np.pi / TURNS
SLOPE = Parameter("slope", 1.0, 0.0, 4.0, 0.1)


def torque(slope, replay):
    """Straight in the slope; of a rough run with a wave in it that a hundredth turns over."""
    wave = np.sin(TURNS * slope) if replay.name == "rough" else 0.0
    return slope * replay.inputs["u"] + wave


@dataclass(frozen=True)
class Straight:
    """A model with one number."""

    parameters: tuple[Parameter, ...] = (SLOPE,)

    def predict(self, values, replays):
        return {"torque": [torque(values["slope"], r) for r in replays]}


def runs(*names):
    made = [toy_replay(name, seed) for seed, name in enumerate(names)]
    for replay in made:
        replay.observed["torque"].values[:] += torque(TRUE, replay) - replay.inputs["u"]
    return made


def test_a_fit_that_a_rough_run_stops_is_led_to_its_end():
    fitter = Fitter(Straight(), runs("one", "two", "three", "rough"))
    stopped = fitter.fit({"slope": BESIDE})
    assert stopped.values["slope"] < TRUE - 0.2
    led = led_by_calm_runs(fitter, stopped.values, stopped.residuals)
    assert led is not None
    assert led.values["slope"] == pytest.approx(TRUE, abs=1e-3)


def test_calm_runs_alone_need_no_lead():
    fitter = Fitter(Straight(), runs("one", "two", "three"))
    fit = fitter.fit({"slope": 1.0})
    assert led_by_calm_runs(fitter, fit.values, fit.residuals) is None


def test_rough_runs_that_are_most_have_none_to_follow():
    fitter = Fitter(Straight(), [*runs("rough", "one"), *runs("rough")])
    fit = fitter.fit({"slope": 1.0})
    assert led_by_calm_runs(fitter, fit.values, fit.residuals) is None
