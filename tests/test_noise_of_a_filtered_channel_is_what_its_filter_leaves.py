"""A filter makes noise smaller and smooth: it is told from what the column holds."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.noise import channel_noise
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

TIME = 0.004 * np.arange(2000)
NOISE = np.random.default_rng(5).normal(0.0, 1.0, TIME.size)
ANGLE = 30.0 * np.sin(3.0 * TIME)
FILTER = 'filter = { kind = "butterworth", order = 2, cutoff = "20 Hz" }\n'


def _load(folder, key):
    rows = [
        f"0,{1e3 * t:.1f},{a:.6f},{np.cos(t):.6f}" for t, a in zip(TIME, ANGLE + NOISE, strict=True)
    ]
    (folder / "data.csv").write_text("\n".join(["take,ms,angle,torque", *rows]), encoding="utf-8")
    described = MAP.replace("may_rest = true\n", f"may_rest = true\n{key}")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


@pytest.mark.parametrize("stated", ["", 'noise = "1 deg"\n'])
def test_estimated_or_stated(tmp_path, stated):
    recording = _load(tmp_path, FILTER + stated)
    left = np.degrees(recording.runs[0].channels["position"]) + ANGLE
    # The wave goes through; the deviation of 8 s of noise below 20 Hz is known to 5 %.
    seen = float(np.std(left[50:-50]))
    assert np.degrees(channel_noise(recording, "position")) == pytest.approx(seen, rel=0.1)


def test_of_a_channel_between_rows(tmp_path):
    keys = ("", 'clock_shift = "2 ms"\n')
    own, mean_of_two = (channel_noise(_load(tmp_path, key), "position") for key in keys)
    assert mean_of_two == pytest.approx(np.sqrt(0.5) * own, rel=1e-3)


def test_a_cutoff_above_half_the_rate_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match=r"filter\.cutoff.*got \"125 Hz\".*less than 125 Hz"):
        _load(tmp_path, FILTER.replace("20 Hz", "125 Hz"))
