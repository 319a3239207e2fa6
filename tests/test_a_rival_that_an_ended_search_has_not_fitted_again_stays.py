"""Where a search was ended before a rival was fitted beside later effects, nothing excludes it."""

from dataclasses import dataclass, field, replace

import numpy as np
from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.effort import Effort
from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Split, Trial, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.tracing.revision import asked_again
from simpter_hybrid.identification.tracing.verdict import Verdict

SIZE = (Parameter("gain as well", 0.0, -5.0, 5.0, 0.05),)
ALIKE = Candidate("alike", SIZE, ((0.1,),), "z", "friction", ("friction:x",))


@dataclass(frozen=True)
class BoundedRig(ToyRig):
    """The toy with an effect that does what that along x does, and a bound on its search."""

    effort: Effort = field(default_factory=Effort, compare=False)

    def extended(self, candidate):
        return replace(self, parameters=(*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        gain = values.get("gain", 0.0) + values.get("gain as well", 0.0)
        return super().predict({**values, "gain": gain}, replays)


def _run(name, seed):
    run = toy_replay(name, seed, gain=0.2)
    seen = run.observed["torque"]
    return replace(run, observed={"torque": replace(seen, values=seen.values + run.inputs["y"])})


def test_one_that_would_do_as_well():
    split = Split([_run("fit", 1)], [_run("select", 2)], [])
    rig = BoundedRig()
    declared = refitted(rig, split)
    model = refitted(rig.extended(ALONG_X).extended(ALONG_Y), split, (ALONG_X, ALONG_Y))
    # Its trial ended far from where it goes with the second effect: so it leaves three times more.
    far = Fit({"gain as well": 2.0}, 0.0, np.empty((0, 0)), np.empty(0))
    rival = Trial(ALIKE, far, 0.0, 0.0, 0.0)
    first = Verdict("cannot be told apart", replace(rival, candidate=ALONG_X), (rival,))
    rig.effort.most = -1.0
    assert asked_again(first, model, declared, split, floor=1.0).rivals == (rival,)
    rig.effort.most = np.inf
    assert asked_again(first, model, declared, split, floor=1.0).rivals == (rival,)
