"""Windows set from noisy speeds: what a start adds is no lack of the model."""

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis_rig import smooth_places
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.replay import Observation
from simpter_hybrid.identification.residual import deviation


@pytest.mark.parametrize("noise", [0.01, 0.1])
def test_the_exact_model_is_called_right(tmp_path, noise):
    done = diagnose(recorded_axis(tmp_path, (), noise), declared_axis()).diagnosis
    assert done.verdict.kind == "nothing missing"
    # 1.25 and more where windows began beside reversals and kept what their starts added.
    assert done.corrected.select < 1.1 * done.floor


def test_a_window_starts_beside_a_bend_and_not_in_it():
    time = np.arange(600)
    speed = np.abs(time - 300.0) / 100.0
    places = smooth_places(speed, [0, 300], 5)
    assert places[0] == 0
    assert abs(places[1] - 300) > 5


def test_a_constant_is_taken_from_every_window_of_speeds():
    seen = Observation(
        np.r_[np.ones(5), 3.0 + np.arange(5)], 1.0, np.ones(10, bool), windows=(0, 5), start=0
    )
    assert deviation(seen, np.zeros(10)) == pytest.approx(np.r_[np.zeros(5), np.arange(5) - 2.0])
