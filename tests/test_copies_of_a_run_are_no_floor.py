"""Runs that differ in nothing tell of no noise: what is told is then judged by the stated noise."""

import numpy as np

from simpter_hybrid.identification.fitting.floor import Weighed
from simpter_hybrid.identification.fitting.lack_of_fit import lack_of_fit


def test_a_lack_is_judged_by_the_stated_floor() -> None:
    left = [Weighed("force", np.random.default_rng(0).normal(size=400))]
    copied = [Weighed("force", np.zeros(400))]
    assert lack_of_fit(left, copied, 1.0) == lack_of_fit(left, [], 1.0)
