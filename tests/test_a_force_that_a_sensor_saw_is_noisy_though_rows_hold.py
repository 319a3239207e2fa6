"""Which channels get their noise once more when it is asked what noise does to a prediction."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import recorded_axis

from simpter_hybrid.identification.rigs.input_noise import InputNoise


def _moved(recording, **known):
    noise = InputNoise(None, recording, None, **known)
    before, after = recording.runs[0].channels, noise.disturbed(1).runs[0].channels
    return float(np.std(after["torque"] - before["torque"]))


@pytest.mark.parametrize(
    ("known", "stated", "is_moved"),
    [
        ({"sensed": frozenset({"torque"})}, None, True),
        ({}, None, False),  # told, as a command that a row holds
        ({}, 0.01, True),  # the map states its noise
        ({"exact": frozenset({"torque"}), "sensed": frozenset({"torque"})}, None, False),
    ],
)
def test_a_torque_whose_rows_hold(tmp_path, known, stated, is_moved):
    recording = recorded_axis(tmp_path, ())
    held = replace(recording.channels["torque"], held="after", noise=stated)
    channels = {**recording.map.channels, "torque": held}
    recording = replace(recording, map=replace(recording.map, channels=channels))
    noisy = _moved(recording, **known)
    assert (noisy > 0.0) is is_moved
    if stated is not None:
        assert noisy == pytest.approx(stated, rel=0.1)  # 1,000 samples: 2 %
