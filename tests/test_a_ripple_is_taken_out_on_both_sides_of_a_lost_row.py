"""Where single rows are lost, those between them come evenly and show a sensor's ripple as ever."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.speed_ripple import Moved, without_ripple

NOISE = 0.05


def test_a_ripple_is_taken_out_on_both_sides_of_a_lost_row():
    time = np.delete(np.arange(0.0, 8.0, 0.005), [400, 410, 1000])
    true = 90.0 * np.exp(-time / 6.0)
    place = 540.0 * (1.0 - np.exp(-time / 6.0))
    noise = np.random.default_rng(1).normal(0.0, NOISE, time.size)
    shown = true * (1.0 + 0.004 * np.sin(2.0 * place)) + noise
    (left,), _ = without_ripple([Moved(time, place, shown)])
    # Also in the nine rows between two lost ones, over which no motion is followed.
    assert np.std((left - true)[400:409]) < 2.0 * NOISE
    assert np.std(left - true) == pytest.approx(NOISE, rel=0.05)
