"""While a second effect is missing the errors say little about which of two first ones is right."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Split, Trial, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.tracing.revision import asked_again
from simpter_hybrid.identification.tracing.verdict import Verdict

BENT = Candidate(
    "bent", (Parameter("bent", 0.0, -5.0, 5.0, 0.05),), ((0.1,),), "z", "friction", ("friction:x",)
)


@dataclass(frozen=True)
class BentRig(ToyRig):
    """The toy with a third effect, a function of x that bends a little."""

    def extended(self, candidate):
        return BentRig((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        made = super().predict(values, replays)["torque"]
        bent = [values.get("bent", 0.0) * r.inputs["x"] ** 3 for r in replays]
        return {"torque": [a + b for a, b in zip(made, bent, strict=True)]}


def _run(name, seed):
    run = toy_replay(name, seed, gain=0.2, noise=0.1)
    seen = run.observed["torque"]
    both = replace(seen, values=seen.values + run.inputs["y"])
    return replace(run, observed={"torque": both})


@pytest.mark.parametrize("one_way", [False, True])
def test_a_rival_falls_when_the_second_effect_is_in_place(one_way):
    split = Split([_run("fit", 1)], [_run("select", 2)], [])
    declared = refitted(BentRig(), split)
    model = refitted(BentRig().extended(ALONG_X).extended(ALONG_Y), split, (ALONG_X, ALONG_Y))
    nothing = Fit({"bent": 0.4}, 0.0, np.empty((0, 0)), np.empty(0))
    rival = Trial(BENT, nothing, 0.0, 0.0, 0.0)
    best = replace(rival, candidate=ALONG_X)
    first = Verdict("cannot be told apart", best, (rival,))
    asked = asked_again(first, model, declared, split, floor=1.0, one_way=one_way)
    # The best cube leaves sqrt(0.1) of a sine: 0.2 / sqrt(2) * 0.32 = 0.45 sd, 10 % more error.
    assert bool(asked.rivals) is one_way


def test_with_one_effect_nothing_is_asked_again():
    split = Split([_run("fit", 1)], [_run("select", 2)], [])
    model = refitted(BentRig().extended(ALONG_X), split, (ALONG_X,))
    verdict = Verdict("effect", Trial(ALONG_X, None, 1.0, 0.5, 1.0), ())
    assert asked_again(verdict, model, model, split, 1.0) is verdict
