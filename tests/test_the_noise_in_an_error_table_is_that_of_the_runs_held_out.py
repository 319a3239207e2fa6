"""A channel's row tells its error over the noise of the runs held out, as the weighed row does."""

from types import SimpleNamespace

import numpy as np
import pytest
from axis_recordings import MAP, SPEED, written

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.fitting.floor import noise_floor
from simpter_hybrid.identification.recordings.noise import channel_noise
from simpter_hybrid.identification.reporting.held_out_data import noise_of_channels

NOISE = 0.01


def test_though_half_of_all_runs_are_quieter(tmp_path):
    draw, rows = np.random.default_rng(2), ["take,ms,angle,torque,rate"]
    for take, noise in enumerate((NOISE, NOISE, 3.0 * NOISE)):
        for k in range(400):
            rate = np.cos(0.05 * k) + noise * draw.standard_normal()
            angle = np.degrees(np.sin(0.05 * k) / 12.5)
            rows.append(f"{take},{4 * k},{angle:.6f},{np.sin(0.05 * k):.4f},{rate:.9f}")
    recording = written(tmp_path, rows, MAP + SPEED)
    *_, noisy = axis_replays(recording, AxisSignals())
    told = noise_of_channels(SimpleNamespace(replays=[noisy]), recording)["speed"]
    # Third differences of 400 rows tell a deviation to 5 %.
    assert told == pytest.approx(3.0 * NOISE, rel=0.2)
    assert told > 2.0 * channel_noise(recording, "speed")
    assert told == pytest.approx(noise_floor([noisy]) * noisy.observed["speed"].sd)
