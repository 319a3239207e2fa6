"""A curve over friction and a scale of it can say the same: the scale stays where it was."""

from dataclasses import dataclass

import numpy as np
import pytest

from simpter_hybrid.identification.empirical import _at_its_level
from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.fitted_model import (
    Split,
    Trial,
    fitted_model,
    refitted,
)
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay

SCALE = Parameter("scale", 1.0, 0.5, 1.5, 0.01, tolerance=0.04)
KNOTS = tuple(Parameter(f"c{k}", 0.0, -1.0, 10.0, 0.05) for k in range(3))
CURVE = Candidate("curve", KNOTS, ((0.1, 0.1, 0.1),), "curve", "friction", (),
                  sizes=tuple(p.name for p in KNOTS))  # fmt: skip
WAVE = np.array([0.1, -0.1, 0.0])


@dataclass(frozen=True)
class ThreeThirds:
    """Torque of a scale, with a change in each third of a run: all three are the scale."""

    parameters: tuple[Parameter, ...] = (SCALE,)

    def extended(self, candidate):
        return type(self)((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        thirds = [values["scale"] + values.get(p.name, 0.0) for p in KNOTS]
        return {"torque": [np.repeat(thirds, 100) for _ in replays]}


def run(name, seed):
    torque = np.repeat(1.0 + WAVE, 100) + 0.01 * np.random.default_rng(seed).standard_normal(300)
    seen = Observation(torque, 0.01, np.ones(300, bool))
    return Replay(name, "a", 0.01 * np.arange(300.0), {}, {"torque": seen})


def test_which_had_wandered_off_together():
    split = Split([run("a", 1)], [run("b", 2)], [run("c", 3)])
    base = refitted(ThreeThirds(), split)
    fitter = Fitter(ThreeThirds().extended(CURVE), split.fit)
    off = {"scale": 0.86, **{f"c{k}": 0.14 + w for k, w in enumerate(WAVE)}}
    fit = fitter.fit(off, iterations=0)
    model = fitted_model(fitter, fit, split, (CURVE,))
    assert model.values["scale"] == 0.86
    there = _at_its_level(model, Trial(CURVE, fit, 1.0, 0.5, 0.5), base, split)
    knots = [there.values[p.name] for p in KNOTS]
    # A mean of 300 rows with noise of 0.01 is sure to 0.0006.
    assert there.values["scale"] == pytest.approx(1.0, abs=3e-3)
    assert knots == pytest.approx(WAVE, abs=3e-3)
    assert there.select_error == pytest.approx(model.select_error, rel=0.01)
