"""A form that was fitted while another effect was missing ends beside the valley that both have."""

from dataclasses import dataclass, field

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.tracing.revision import begun_anew

TIME = np.linspace(0.0, 3.0, 400)
SCALE = Parameter("scale", 1.0, 0.5, 1.5, 0.05, 0.1)
DRIFT = Candidate("drift", (Parameter("drift.rate", 0.0, -1.0, 1.0, 0.02),), ((0.0,),), "a", "load",
                  ("force:time",))  # fmt: skip
WAVE = Candidate(
    "wave",
    (Parameter("wave.size", 0.0, -2.0, 2.0, 0.02), Parameter("wave.number", 3.0, 0.5, 20.0, 0.1)),
    ((0.3, 3.0), (0.3, 9.0)), "b", "load", ("force:position",),
)  # fmt: skip


@dataclass(frozen=True)
class Line:
    """scale + rate t + size sin(number t): the sine has many valleys."""

    effects: tuple = ()
    parameters: tuple = field(default=(SCALE,))

    def extended(self, candidate):
        return Line((*self.effects, candidate), (*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        size, number = values.get("wave.size", 0.0), values.get("wave.number", 0.0)
        made = values["scale"] + values.get("drift.rate", 0.0) * TIME + size * np.sin(number * TIME)
        return {"force": [made for _ in replays]}


def _runs(seed):
    noise = 0.05 * np.random.default_rng(seed).standard_normal(TIME.size)
    seen = 1.0 + 0.3 * TIME + 0.5 * np.sin(9.3 * TIME) + noise
    return [Replay("run", "run", TIME, {}, {"force": Observation(seen, 0.05, TIME >= 0.0)})]


def test_from_the_starts_of_each():
    split = Split(_runs(1), _runs(2), _runs(3))
    declared = refitted(Line(), split)
    both = Line().extended(DRIFT).extended(WAVE)
    beside = {"scale": 1.0, "drift.rate": 0.3, "wave.size": 0.05, "wave.number": 3.0}
    stuck = refitted(both, split, (DRIFT, WAVE), beside)
    assert stuck.select_error > 3.0
    found = begun_anew(stuck, declared, split, floor=1.0)
    assert found.select_error == pytest.approx(1.0, abs=0.15)  # of 400 samples
    assert found.values["wave.number"] == pytest.approx(9.3, abs=0.05)
    assert begun_anew(found, declared, split, floor=1.0) is found
