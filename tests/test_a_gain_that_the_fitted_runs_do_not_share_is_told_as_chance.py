"""A candidate that helps the selecting runs alone counts for nothing, and its row says so."""

import pytest
from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.search import try_candidates
from simpter_hybrid.identification.reporting.round_data import round_data
from simpter_hybrid.identification.reporting.tables import BY_CHANCE, candidate_table
from simpter_hybrid.identification.tracing.further import helpful
from simpter_hybrid.identification.tracing.round import Round
from simpter_hybrid.identification.tracing.verdict import Verdict


@pytest.mark.parametrize(("there", "chance"), [(0.01, True), (0.3, False)])
def test_and_only_then(there, chance):
    runs = [toy_replay("a", 1, gain=there), toy_replay("b", 2, gain=0.3, experiment="b")]
    split = Split(runs[:1], runs[1:], [])
    base = refitted(ToyRig(), split)
    (trial,) = try_candidates(base, [ALONG_X], split, 1.0)
    assert trial.gain > 0.0
    assert helpful([trial], base, ["friction:x"], 1.0) == ([] if chance else [trial])
    page = candidate_table(
        0, round_data(Round({}, {}, (trial,), Verdict("unknown"), base=base), None)
    )
    assert (BY_CHANCE in page) is chance
