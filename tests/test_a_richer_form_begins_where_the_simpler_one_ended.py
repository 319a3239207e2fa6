"""A form that contains another is at least as good as it on the fitted runs."""

from dataclasses import replace

from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.predictor import Parameter
from simpter_hybrid.identification.search import Split, grown, refitted, try_candidates

RICHER = replace(
    ALONG_X,
    name="richer",
    parameters=(
        Parameter("richer.gain", 0.0, -5.0, 5.0, 0.05),
        Parameter("richer.bend", 1.0, 0.5, 2.0, 0.1),
    ),
    starts=((4.9, 2.0),),
    simpler="simple",
)
SIMPLE = replace(
    ALONG_X, name="simple", parameters=(Parameter("simple.gain", 0.0, -5.0, 5.0, 0.05),)
)


class Bent(ToyRig):
    """The gain counts only where it is not bent: away from a bend of 1 the fit sees a plateau."""

    def extended(self, candidate):
        return Bent((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        gain = values.get("simple.gain", 0.0)
        if abs(values.get("richer.bend", 1.0) - 1.0) < 0.2:
            gain += values.get("richer.gain", 0.0)
        return super().predict({**values, "gain": gain}, replays)


def test_where_its_own_start_leads_nowhere():
    runs = [toy_replay(name, seed, gain=0.3) for name, seed in (("one", 1), ("two", 2))]
    split = Split(runs[:1], runs[1:], [])
    base = refitted(Bent(), split)
    trials = {t.candidate.name: t for t in try_candidates(base, [SIMPLE, RICHER], split, 0.5)}
    assert trials["richer"].fit.cost <= trials["simple"].fit.cost * (1 + 1e-9)
    assert abs(trials["richer"].fit.values["richer.gain"] - 0.3) < 0.02


def test_what_the_simpler_form_does_not_know_does_nothing():
    runs = [toy_replay("one", 1, gain=0.3)]
    split = Split(runs, runs, [])
    (simple,) = try_candidates(refitted(Bent(), split), [SIMPLE], split, floor=0.5)
    start = grown(RICHER, simple)
    assert start["richer.bend"] == 1.0
    assert start["richer.gain"] == simple.fit.values["simple.gain"]
    assert "simple.gain" not in start
