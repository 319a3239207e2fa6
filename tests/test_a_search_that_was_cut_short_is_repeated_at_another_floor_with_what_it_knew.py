"""What was fitted before the effort was used up is found again when the floor turns out higher."""

from dataclasses import dataclass, field, replace

from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.effort import Effort
from simpter_hybrid.identification.fitting.farther import finished
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.memory import Memory
from simpter_hybrid.identification.fitting.search import try_candidates
from simpter_hybrid.identification.fitting.survey import survey


@dataclass(frozen=True)
class Counted(ToyRig):
    """A rig whose runs count."""

    effort: Effort = field(default_factory=Effort)

    def extended(self, candidate):
        return replace(self, parameters=(*self.parameters, *candidate.parameters))


def test_of_all_that_was_fitted_and_of_no_more():
    runs = [toy_replay("a", 1, gain=0.3), toy_replay("b", 2, gain=0.3, experiment="b")]
    split, memory = Split(runs[:1], runs[1:], []), Memory()
    base = refitted(Counted(), split)
    probes = survey(base, [ALONG_X, ALONG_Y], split.fit)

    def ended(probes, floor, memory):
        trials = try_candidates(base, [], split, floor, probes=probes, memory=memory)
        return [finished(base, t, split, floor, memory) for t in trials]

    first = ended(probes[:1], 1.0, memory)
    base.predictor.effort.ended = lambda: True
    again = ended(probes, 0.5, memory)
    assert [t.candidate.name for t in again] == ["along x"]
    assert again[0].fit.cost == first[0].fit.cost < base.cost
    assert ended(probes, 0.5, Memory()) == []
