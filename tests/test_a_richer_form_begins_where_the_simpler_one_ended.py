"""A form that contains another is at least as good as it on the fitted runs."""

from dataclasses import replace

import pytest
from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.search import try_candidates
from simpter_hybrid.identification.fitting.starts import grown
from simpter_hybrid.identification.fitting.survey import survey

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
#: With a gain for each of two; its own start is on the plateau.
FOR_EACH = replace(
    RICHER,
    name="for each",
    parameters=(
        Parameter("for each.1.gain", 0.0, -5.0, 5.0, 0.05),
        Parameter("for each.2.gain", 0.0, -5.0, 5.0, 0.05),
        Parameter("for each.bend", 1.0, 0.5, 2.0, 0.1),
    ),
    starts=((4.9, 4.9, 2.0),),
    simpler="",
    plain="simple",
)


class Bent(ToyRig):
    """The gain counts only where it is not bent: away from a bend of 1 the fit sees a plateau."""

    def extended(self, candidate):
        return Bent((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        gain = values.get("simple.gain", 0.0)
        if abs(values.get("richer.bend", 1.0) - 1.0) < 0.2:
            gain += values.get("richer.gain", 0.0)
        if abs(values.get("for each.bend", 1.0) - 1.0) < 0.2:
            gain += (values.get("for each.1.gain", 0.0) + values.get("for each.2.gain", 0.0)) / 2
        return super().predict({**values, "gain": gain}, replays)


@pytest.mark.parametrize("richer", [RICHER, FOR_EACH])
def test_where_its_own_start_leads_nowhere(richer):
    runs = [toy_replay(name, seed, gain=0.3) for name, seed in (("one", 1), ("two", 2))]
    split = Split(runs[:1], runs[1:], [])
    base = refitted(Bent(), split)
    # Whatever the start promises: here it is asked where the fit ends.
    probes = [replace(p, gain=1.0) for p in survey(base, [SIMPLE, richer], split.fit)]
    tried = try_candidates(base, [SIMPLE, richer], split, 0.5, probes=probes)
    trials = {t.candidate.name: t for t in tried}
    ended = trials[richer.name].fit
    assert ended.cost <= trials["simple"].fit.cost * (1 + 1e-9)
    gains = [v for name, v in ended.values.items() if name.startswith(f"{richer.name}.")][:-1]
    assert abs(sum(gains) / len(gains) - 0.3) < 0.02


def test_what_the_simpler_form_does_not_know_does_nothing():
    runs = [toy_replay("one", 1, gain=0.3)]
    split = Split(runs, runs, [])
    (simple,) = try_candidates(refitted(Bent(), split), [SIMPLE], split, floor=0.5)
    start = grown(RICHER, simple)
    assert start["richer.bend"] == 1.0
    assert start["richer.gain"] == simple.fit.values["simple.gain"]
    assert "simple.gain" not in start


def test_a_size_for_each_begins_with_that_for_all():
    runs = [toy_replay("one", 1, gain=0.3)]
    split = Split(runs, runs, [])
    (simple,) = try_candidates(refitted(Bent(), split), [SIMPLE], split, floor=0.5)
    start, gain = grown(FOR_EACH, simple), simple.fit.values["simple.gain"]
    own = ("for each.1.gain", "for each.2.gain", "for each.bend")
    assert [start[name] for name in own] == [gain, gain, 1.0]
