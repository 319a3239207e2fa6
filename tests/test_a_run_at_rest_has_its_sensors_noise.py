"""A tachometer stays at one value while an axis rests: its noise is that of other runs."""

import numpy as np
import pytest
from axis_recordings import MAP, SPEED, written

from simpter_hybrid.identification.recordings.noise import channel_noise, noise_in

NOISE = 0.01


def test_it_is_neither_nothing_nor_that_of_a_quieter_run(tmp_path):
    draw, rows = np.random.default_rng(2), ["take,ms,angle,torque,rate"]
    for take, size in enumerate((1.0, 0.5, 0.0)):
        for k in range(400):
            rate = (np.cos(0.05 * k) + NOISE * draw.standard_normal()) * size
            rows.append(f"{take},{4 * k},{np.sin(0.05 * k):.5f},{np.sin(0.05 * k):.4f},{rate:.9f}")
    recording = written(tmp_path, rows, MAP + SPEED)
    first, second, resting = (noise_in(run, recording, "speed") for run in recording.runs)
    # Third differences of 400 rows tell a deviation to 5 %.
    assert first == pytest.approx(NOISE, rel=0.2)
    assert second == pytest.approx(NOISE / 2, rel=0.2)
    assert resting == channel_noise(recording, "speed")
