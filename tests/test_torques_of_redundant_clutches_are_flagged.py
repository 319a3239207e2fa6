"""Unique while two independent clutches hold, a flagged convention as soon as a third does."""

from sampled_runs import baseline, locked

from simpter_hybrid.measuring.sampling import sample


def test_four_stuck_clutches_of_pter_share_by_convention():
    s = sample(locked())
    stuck = (s.mode == 0).sum(axis=1)
    assert set(stuck.tolist()) >= {1, 4}
    assert not s.unique[stuck == 4].any()
    assert s.unique[stuck < 3].all()


def test_single_stuck_clutches_are_unique():
    assert sample(baseline()).unique.all()


def test_no_torque_exceeds_its_limit():
    for run in (baseline(), locked()):
        s = sample(run)
        # The sharing convention stops at the limits; a located breakaway is at it to rounding.
        assert (abs(s.tau) <= s.tau_break + 1e-9).all()
