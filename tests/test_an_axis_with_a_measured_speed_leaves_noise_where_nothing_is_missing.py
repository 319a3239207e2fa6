"""Windows set from noisy speeds: what a start adds is no lack of the model."""

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.windows import smooth_places
from simpter_hybrid.identification.diagnosis import diagnose


@pytest.mark.slow
@pytest.mark.parametrize("noise", [0.01, 0.1])
def test_the_exact_model_is_called_right(tmp_path, noise):
    done = diagnose(recorded_axis(tmp_path, (), noise), declared_axis()).search
    assert done.verdict.kind == "nothing missing"
    # A start from 9 noisy samples adds half a deviation to all of its window.
    assert done.corrected.select_error < 1.2 * done.floor


def test_a_window_starts_beside_a_bend_and_not_in_it():
    time = np.arange(600)
    speed = np.abs(time - 300.0) / 100.0
    places = smooth_places(speed, [0, 300], 5)
    assert places[0] == 0
    assert abs(places[1] - 300) > 5
