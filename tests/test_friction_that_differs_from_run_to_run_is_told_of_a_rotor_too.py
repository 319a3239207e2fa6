"""Where no effect explains what a rotor lacks, each run is asked for a value of its own."""

from dataclasses import dataclass, replace

import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.fitting.replicates import merged
from simpter_hybrid.identification.runwise_told import OF_RUNS, told_alone
from simpter_hybrid.identification.tracing.limits import SINGLE
from simpter_hybrid.identification.tracing.rounds import SearchResult
from simpter_hybrid.identification.tracing.verdict import Verdict
from simpter_hybrid.identification.weighted_search import WeightedSearchResult


@dataclass(frozen=True)
class OwnRig(ToyRig):
    """A toy whose runs may have values of their own."""

    def predict(self, values, replays):
        each = [super(OwnRig, self).predict(_own(values, r), [r])["torque"] for r in replays]
        return {"torque": [one for (one,) in each]}

    def with_wider(self, wider):
        names = {p.name: p for p in wider}
        return replace(self, parameters=tuple(names.get(p.name, p) for p in self.parameters))


def _own(values, run):
    return {n: v * run.own.get(n, 1.0) for n, v in values.items()}


def found_of(kind="unknown", scales=(0.9, 1.0, 1.1), gain=0.0):
    """Two batteries of the same runs, that are fitted as means, and a third that selects."""
    kinds = [(f"run {k + 1}", scale) for k, scale in enumerate(scales)]
    batteries = [
        [toy_replay(f"battery {b}, {n}", 10 * b + k, s, gain, experiment=n)
         for k, (n, s) in enumerate(kinds)]
        for b in range(3)
    ]  # fmt: skip
    fitted, select = [*batteries[0], *batteries[1]], batteries[2]
    split = Split(merged(fitted), select, select)
    model = refitted(OwnRig(), split)
    verdict = Verdict(kind, coordinates=("friction:speed",))
    done = SearchResult(model, model, (), verdict, 1.0)
    floors = Floors(1.0, 1.0, 1.0)
    return WeightedSearchResult(done, split, None, fitted, SINGLE, 1.0, floors)


def test_each_run_has_a_value_and_the_verdict_says_so():
    told, (levels,) = told_alone(found_of(), ["scale"])
    assert told.search.verdict == Verdict("unknown", coordinates=(OF_RUNS,))
    assert [name for name, _ in levels.levels][:3] == [f"battery 0, run {k}" for k in (1, 2, 3)]
    # Half a run's 1000 samples of 1.06 rms with noise 0.1 know a scale to 0.003; three of them.
    assert [v for _, v in levels.levels] == pytest.approx([0.9, 1.0, 1.1] * 3, abs=0.012)


@pytest.mark.parametrize("kind", ["effect", "lack or noise", "nothing missing"])
def test_nothing_is_asked_where_something_was_named_or_nothing_is_missing(kind):
    found = found_of(kind)
    assert told_alone(found, ["scale"]) == (found, ())


def test_what_is_in_every_run_alike_leaves_the_verdict():
    found = found_of(scales=(1.0, 1.0, 1.0), gain=0.3)
    told, _ = told_alone(found, ["scale"])
    assert told is found
