"""In short windows of noisy positions any model is as good as another, one at rest among them."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.window_length import (
    LONGEST_WINDOW,
    SEEN,
    bent_by,
    straight,
    window_length,
)
from simpter_hybrid.identification.recordings.recording import load_recording

S = AxisSignals()


def _recorded(folder, noise, period=10.0, lasts=20.0):
    """Three runs, in degrees: a swing of 50 in `period` [s], white `noise`."""
    rng = np.random.default_rng(1)
    rows = []
    for run in range(3):
        t = 0.02 * np.arange(round(50 * lasts))
        angle = 50.0 * np.sin(2 * np.pi * t / period) + noise * rng.standard_normal(t.size)
        rows += [
            f"{run},{1000 * s:.0f},{a:.6f},{k % 5}"
            for k, (s, a) in enumerate(zip(t, angle, strict=True))
        ]
    (folder / "data.csv").write_text("\n".join(["take,ms,angle,torque", *rows]), encoding="utf-8")
    (folder / "map.toml").write_text(MAP, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_half_a_second_does_where_the_sensor_is_fine(tmp_path):
    assert window_length(_recorded(tmp_path, 0.01), S) == 0.5


@pytest.mark.parametrize(("lasts", "length"), [(20.0, LONGEST_WINDOW), (9.0, 4.0), (1.5, 0.5)])
def test_they_are_no_longer_than_half_a_run_or_than_a_start_carries(tmp_path, lasts, length):
    recording = _recorded(tmp_path, 0.3, period=80.0, lasts=lasts)
    assert window_length(recording, S) == length


def test_none_shorter_would_do(tmp_path):
    recording = _recorded(tmp_path, 5.0)
    length = window_length(recording, S)
    noise = np.deg2rad(5.0)
    assert bent_by(recording.runs, S.position, 0.5 * length) < SEEN * noise
    assert bent_by(recording.runs, S.position, length) >= SEEN * noise * 0.9  # noise is estimated


def test_without_any_noise_half_a_second_does(tmp_path):
    recording = _recorded(tmp_path, 1.0)
    exact = replace(recording.channels[S.position], noise=0.0, step=None)
    described = replace(recording.map, channels={**recording.channels, S.position: exact})
    exactly = replace(recording, map=described)
    assert window_length(exactly, S) == 0.5
    assert straight(exactly, S, 0.5) == ()


def test_what_even_the_longest_do_not_show_is_told(tmp_path):
    (said,) = straight(_recorded(tmp_path, 5.0), S, 1.0)
    assert "hardly more than noise" in said.what
    assert straight(_recorded(tmp_path, 1.0), S, 2.0) == ()
