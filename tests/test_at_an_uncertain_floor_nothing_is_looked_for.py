"""Positions so far apart that friction bends the course within a start's fit: no small names."""

import pytest
from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.tracing.limits import COARSE_AXIS, SIMULATED_AXIS
from simpter_hybrid.identification.tracing.rounds import search_effects


@pytest.mark.parametrize(("limit", "named"), [(SIMULATED_AXIS, ["along x"]), (COARSE_AXIS, [])])
def test_a_small_lack_is_named_only_where_the_floor_is_known(limit, named):
    runs = [toy_replay(f"run {k}", k, gain=0.08, experiment="ab"[k % 2]) for k in range(4)]
    split = Split(runs[:2], runs[2:], [])
    base = refitted(ToyRig(), split)
    done = search_effects(base, [ALONG_X], split, lambda *_: {}, floor=1.0, limit=limit)
    assert 1.05 < base.select_error < 1.5
    assert [e.name for e in done.corrected.effects] == named


def test_a_large_one_is_named_all_the_same():
    runs = [toy_replay(f"run {k}", k, gain=0.4, experiment="ab"[k % 2]) for k in range(4)]
    split = Split(runs[:2], runs[2:], [])
    base = refitted(ToyRig(), split)
    done = search_effects(base, [ALONG_X], split, lambda *_: {}, floor=1.0, limit=COARSE_AXIS)
    assert [e.name for e in done.corrected.effects] == ["along x"]
