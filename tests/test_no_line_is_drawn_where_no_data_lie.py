"""Strokes at three speeds tell of three speeds, and not of what lies between them."""

import numpy as np
import pytest

from simpter_hybrid.plots.diagnosis import stretches

CLUSTERS = np.r_[-1.57 + 0.01 * np.arange(5), 0.001 * np.arange(2), 1.02 + 0.01 * np.arange(5)]


@pytest.mark.parametrize(
    ("centres", "sizes"),
    [
        (CLUSTERS, [5, 2, 5]),
        (np.linspace(0.0, 1.0, 12), [12]),
        # Bins of as many rows each are wide where rows are few: that is one curve.
        (np.cumsum(1.3 ** np.arange(12)), [12]),
        (np.array([1.0]), [1]),
    ],
    ids=["clusters", "even", "wider", "one"],
)
def test_bins_far_apart_are_stretches_of_their_own(centres, sizes):
    assert [part.size for part in stretches(centres)] == sizes
