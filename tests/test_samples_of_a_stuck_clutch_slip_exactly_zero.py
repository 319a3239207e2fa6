"""Slip velocity is zero because the degree of freedom is gone: C qd itself gives 0.0."""

import numpy as np
from sampled_runs import baseline, clutch_map_of

from simpter_hybrid.measuring.sampling import sample


def test_samples_of_a_stuck_clutch_slip_exactly_zero():
    s = sample(baseline())
    stuck = s.mode == 0
    assert stuck.sum() > 100
    from_speeds = s.qd @ clutch_map_of(baseline()).T
    assert (from_speeds[stuck] == 0.0).all()
    assert (s.slip[stuck] == 0.0).all()
    # The engine's slip and the product differ by the order of additions only.
    assert np.allclose(s.slip, from_speeds, rtol=0.0, atol=1e-15)
