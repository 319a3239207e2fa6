from toy_rig import ALONG_X, ALONG_Y, ToyRig, toy_replay

from simpter_hybrid.identification.rounds import Diagnosis, Round
from simpter_hybrid.identification.search import Split, refitted, try_candidates, with_effect
from simpter_hybrid.identification.verdict import Verdict
from simpter_hybrid.identification.weighted_search import begun


def test_candidates_that_were_fitted_begin_from_all_their_values_and_others_do_not():
    runs = [toy_replay(name, seed, gain=0.3) for name, seed in (("one", 1), ("two", 2))]
    split = Split(runs[:1], runs[1:], [])
    base = refitted(ToyRig(), split)
    trials = tuple(try_candidates(base, [ALONG_X], split, floor=1.0))
    verdict = Verdict("effect", trials[0], ())
    done = Diagnosis(
        base, with_effect(base, trials[0], split), (Round({}, {}, trials, verdict),), verdict, 1.0
    )
    along_x, along_y = begun((ALONG_X, ALONG_Y), done)
    assert dict(along_x.fitted) == dict(done.corrected.values)
    assert along_y is ALONG_Y
