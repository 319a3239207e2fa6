"""An effect and one that mends what it bends give way to the rival that needs no second one."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Split, Trial, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.tracing.revision import asked_again, with_better_rivals
from simpter_hybrid.identification.tracing.verdict import Verdict


def _along(name):
    number = (Parameter(name, 0.0, -5.0, 5.0, 0.05),)
    return Candidate(name, number, ((0.1,),), name, "friction", ("friction:x",))


CUBED, BOTH = _along("cubed"), _along("both")


@dataclass(frozen=True)
class CubedRig(ToyRig):
    """The toy with x cubed as an effect, and with x and x cubed, alike, as one."""

    def extended(self, candidate):
        return CubedRig((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        cubed, both = values.get("cubed", 0.0), values.get("both", 0.0)
        made = super().predict(values, replays)["torque"]
        more = [cubed * x**3 + both * (x + x**3) for x in (r.inputs["x"] for r in replays)]
        return {"torque": [a + b for a, b in zip(made, more, strict=True)]}


def _run(name, seed, cubed):
    run = toy_replay(name, seed, gain=1.0, noise=0.1)
    seen = run.observed["torque"]
    values = seen.values + cubed * run.inputs["x"] ** 3
    return replace(run, observed={"torque": replace(seen, values=values)})


@pytest.mark.parametrize(("cubed", "named"), [(1.0, [BOTH]), (-1.0, [ALONG_X, CUBED])])
def test_the_rival_is_named_only_if_it_needs_no_second_effect(cubed, named):
    split = Split([_run("fit", 1, cubed)], [_run("select", 2, cubed)], [])
    declared = refitted(CubedRig(), split)
    model = refitted(CubedRig().extended(ALONG_X).extended(CUBED), split, (ALONG_X, CUBED))
    fit = Fit({"both": 0.5}, 0.0, np.empty((0, 0)), np.empty(0))
    rival = Trial(BOTH, fit, 0.0, 0.0, 0.0)
    best, second = replace(rival, candidate=ALONG_X), replace(rival, candidate=CUBED)
    verdicts = [Verdict("cannot be told apart", best, (rival,)), Verdict("effect", second)]
    verdicts, other = with_better_rivals(verdicts, model, declared, split, floor=1.0)
    assert list(other.effects) == named
    assert verdicts[0].accepted.candidate is named[0]
    assert verdicts[0].rivals == ((best,) if named == [BOTH] else (rival,))


class ApartRig(CubedRig):
    """One in which x and x cubed alike do not go together with x cubed: asking is a fault."""

    def extended(self, candidate):
        made = ApartRig((*self.parameters, *candidate.parameters))
        assert not {"cubed", "both"} <= {p.name for p in made.parameters}
        return made

    def combines(self, candidate):
        names = {p.name for p in self.parameters} | {p.name for p in candidate.parameters}
        return not {"cubed", "both"} <= names


def test_a_rival_that_does_not_go_together_with_the_others_takes_no_place():
    split = Split([_run("fit", 1, 1.0)], [_run("select", 2, 1.0)], [])
    declared = refitted(ApartRig(), split)
    model = refitted(ApartRig().extended(ALONG_X).extended(CUBED), split, (ALONG_X, CUBED))
    fit = Fit({"both": 0.5}, 0.0, np.empty((0, 0)), np.empty(0))
    rival = Trial(BOTH, fit, 0.0, 0.0, 0.0)
    best, second = replace(rival, candidate=ALONG_X), replace(rival, candidate=CUBED)
    first = Verdict("cannot be told apart", best, (rival,))
    given = model, declared, split, 1.0
    assert with_better_rivals([first, Verdict("effect", second)], *given)[1] is model
    assert asked_again(first, *given).rivals == (rival,)  # nothing excludes it
