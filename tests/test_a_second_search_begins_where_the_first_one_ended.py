from dataclasses import replace

from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted, with_effect
from simpter_hybrid.identification.fitting.search import try_candidates
from simpter_hybrid.identification.fitting.survey import survey
from simpter_hybrid.identification.next_search import begun
from simpter_hybrid.identification.tracing.round import Round
from simpter_hybrid.identification.tracing.rounds import SearchResult
from simpter_hybrid.identification.tracing.verdict import Verdict


def test_candidates_that_were_fitted_begin_from_all_their_values_and_others_do_not():
    runs = [toy_replay(name, seed, gain=0.3) for name, seed in (("one", 1), ("two", 2))]
    split = Split(runs[:1], runs[1:], [])
    base = refitted(ToyRig(), split)
    trials = tuple(try_candidates(base, [ALONG_X], split, floor=1.0))
    verdict = Verdict("effect", trials[0], ())
    done = SearchResult(
        base, with_effect(base, trials[0], split), (Round({}, {}, trials, verdict),), verdict, 1.0
    )
    along_x, along_y = begun((ALONG_X, ALONG_Y), done)
    assert dict(along_x.fitted) == dict(done.corrected.values)
    assert along_y is ALONG_Y


class Shy(ToyRig):
    """The gain does nothing below 0.2: no linear step from a small one promises anything."""

    def extended(self, candidate):
        return Shy((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        gain = values.get("gain", 0.0)
        return super().predict({**values, "gain": gain if gain > 0.2 else 0.0}, replays)


def test_it_begins_there_although_no_linear_step_promises_anything():
    replay = toy_replay("one", 1, scale=1.1, gain=0.4)
    base = refitted(Shy(), Split([replay], [toy_replay("two", 2, 1.1, 0.4)], []))
    earlier = {"scale": 1.1, "gain": 0.4}
    (new,) = survey(base, [ALONG_X], [replay])
    assert new.gain == 0.0
    (again,) = survey(base, [replace(ALONG_X, fitted=tuple(earlier.items()))], [replay])
    assert again.start == earlier
