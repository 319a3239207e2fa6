"""Too few rows for a parabola tell a speed all the same: none would be taken for a rest."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.smoothing import rate_of_change


@pytest.mark.parametrize("rows", [2, 4])
def test_a_few_rows_between_gaps_have_the_speed_of_a_line(rows):
    bursts = 100.0 + 0.02 * np.arange(50)
    time = (bursts[:, None] + 0.001 * np.arange(rows)).ravel()
    if rows == 2:  # behind a run without gaps, by which the usual step is known
        time = np.concatenate([99.0 + 0.001 * np.arange(500), time])
    assert rate_of_change(time, 3.0 - 2.0 * time, 0.03) == pytest.approx(-2.0, abs=1e-6)
