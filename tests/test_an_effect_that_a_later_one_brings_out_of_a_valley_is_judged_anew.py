"""What a fit left that ended in a valley says nothing of the effect: it is concluded anew."""

from dataclasses import dataclass, replace

import pytest
from toy_rig import ALONG_X, ToyRig, toy_replay, tracer

from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.fitting.fitted_model import Split, fitted_model, refitted
from simpter_hybrid.identification.fitting.memory import Memory
from simpter_hybrid.identification.tracing.limits import REPEATED
from simpter_hybrid.identification.tracing.round import Given, concluded, gone_on, step
from simpter_hybrid.identification.tracing.traced import traced

#: (g^3 - 3 g)/2 is 1 at its hill at -1, to which fits go up from 0.1, and 2 only at 2.196.
HILL, BEYOND = -1.0, 2.196


@dataclass(frozen=True)
class Bent(ToyRig):
    """Of a gain only a cubic of it acts."""

    def extended(self, candidate):
        return Bent((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        gain = values.get("gain", 0.0)
        return super().predict({**values, "gain": (gain**3 - 3.0 * gain) / 2.0}, replays)


@pytest.fixture(scope="module")
def steps():
    """The round that found a gain in the valley, and the same gone on from beyond it."""
    runs = [toy_replay("run", k, gain=2.0, experiment="abc"[k % 3]) for k in range(6)]
    split = Split(runs[:2], runs[2:4], runs[4:])
    given = Given(split, tracer, 1.0, lambda name, gain: None, REPEATED, 1.0, Memory())
    base = refitted(Bent(), split)
    first = step(given, base, [ALONG_X], traced(tracer, base, split))
    predictor = base.predictor.extended(ALONG_X)
    fitter = Fitter(predictor, split.fit)
    end = fitter.fit({**base.values, "gain": 2.1})
    model = fitted_model(fitter, end, split, (ALONG_X,))
    return given, first, gone_on(given, first, model)


def test_the_first_fit_ends_in_the_valley(steps):
    given, first, _ = steps
    assert first.trials[0].fit.values["gain"] == pytest.approx(HILL, abs=0.1)
    assert concluded(given, first)[0].verdict.kind != "effect"


def test_the_round_has_the_fit_from_beyond(steps):
    given, _, again = steps
    assert again.trials[0] is again.believed[0]
    assert again.trials[0].fit.values["gain"] == pytest.approx(BEYOND, abs=0.01)
    done, model, _ = concluded(given, again)
    assert done.verdict.kind == "effect"
    # Noise of 0.1 in 4000 samples: the error is 1 within a few hundredths.
    assert model.select_error == pytest.approx(1.0, abs=0.05)
    assert replace(model.effects[0], fitted=()) == ALONG_X
