"""An oscillation's frequency has valleys side by side; the fit goes on from a deeper one."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from toy_rig import SCALE, toy_replay

from simpter_hybrid.identification.fitting.farther import gone_farther
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.search import try_candidates

SWING = Candidate(
    "swing",
    (
        Parameter("swing.height", 0.0, -5.0, 5.0, 0.05),
        Parameter("swing.frequency", 2.0, 0.1, 9.0, 0.02),
    ),
    ((0.3, 2.0),),
    "x",
    "friction",
    ("friction:x",),
)
TRUE = 2.7


@dataclass(frozen=True)
class Swinging:
    """torque = scale u + height exp(-t/2) sin(frequency t)."""

    parameters: tuple[Parameter, ...] = (SCALE,)

    def extended(self, candidate):
        return Swinging((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        def of(r):
            height, frequency = values.get("swing.height", 0.0), values.get("swing.frequency", 2.0)
            fading = np.exp(-0.5 * r.time) * np.sin(frequency * r.time)
            return values["scale"] * r.inputs["u"] + height * fading

        return {"torque": [of(r) for r in replays]}


def _run(seed):
    replay = toy_replay("run", seed, experiment="abc"[seed % 3])
    swing = 0.5 * np.exp(-0.5 * replay.time) * np.sin(TRUE * replay.time)
    replay.observed["torque"].values[:] += swing
    return replay


@pytest.mark.parametrize("frequency", [2.0, 4.5])
def test_the_frequency_is_found(frequency):
    split = Split([_run(1), _run(2)], [_run(4)], [])
    base = refitted(Swinging(), split)
    (trial,) = try_candidates(base, [replace(SWING, starts=((0.3, frequency),))], split, 1.0)
    stopped = replace(
        trial,
        fit=replace(
            trial.fit,
            values={**trial.fit.values, "swing.height": 0.1, "swing.frequency": frequency},
        ),
    )
    (farther,) = gone_farther(base, [stopped], [stopped], split, 1.0)
    assert farther.fit.values["swing.frequency"] == pytest.approx(TRUE, abs=0.02)
    assert farther.select_error < 1.03
