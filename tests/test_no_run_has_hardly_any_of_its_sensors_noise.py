"""An observer that runs out smoothly has no noise there: such a run would rule all others."""

import numpy as np
import pytest
from axis_recordings import MAP, SPEED, written

from simpter_hybrid.identification.recordings.noise import QUIETEST, channel_noise, noise_in


def test_it_has_a_part_of_the_usual_one_at_least(tmp_path):
    draw, rows = np.random.default_rng(2), ["take,ms,angle,torque,rate"]
    for take, noise in enumerate((0.01, 0.01, 1e-5)):
        for k in range(400):
            rate, angle = np.cos(0.05 * k), np.degrees(np.sin(0.05 * k) / 12.5)
            rate += noise * draw.standard_normal()
            rows.append(f"{take},{4 * k},{angle:.6f},{np.sin(0.05 * k):.4f},{rate:.9f}")
    recording = written(tmp_path, rows, MAP + SPEED)
    usual = channel_noise(recording, "speed")
    *others, quiet = (noise_in(run, recording, "speed") for run in recording.runs)
    assert others == pytest.approx([usual, usual], rel=0.2)
    assert quiet == pytest.approx(QUIETEST * usual)
