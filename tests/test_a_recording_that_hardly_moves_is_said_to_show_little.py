"""An axis at rest, one that jerks once, one that stays within its noise, one that creeps."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.cautions import in_view_of
from simpter_hybrid.problems import InvalidInput

TIME = np.arange(0.0, 8.0, 0.004)
NOISE = 0.02  # [deg]


def _load(folder, course, noise=NOISE):
    """Three takes of a course [deg] under a live torque."""
    generator = np.random.default_rng(5)
    lines = ["take,ms,angle,torque"]
    for take in range(3):
        angle = course + generator.normal(0.0, 1.0, TIME.size) * noise
        rows = zip(1e3 * TIME, angle, np.sin(TIME), strict=True)
        lines += [f"{take},{t:.1f},{a:.3f},{u:.4f}" for t, a, u in rows]
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(MAP, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


@pytest.mark.parametrize("noise", [0.0, NOISE])
@pytest.mark.parametrize("course", [0.0 * TIME, np.full(TIME.size, 12.3456)])
def test_a_recording_at_rest_is_refused(tmp_path, course, noise):
    with pytest.raises(InvalidInput, match="position does not move"):
        _load(tmp_path, course, noise)


@pytest.mark.parametrize(
    ("course", "said"),
    [
        (np.clip(300.0 * (TIME - 4.0), 0.0, 30.0), "% of the time"),
        (6.0 * NOISE * np.sin(3.0 * TIME), "standard deviations"),
    ],
)
def test_little_motion_comes_first_among_the_remarks_and_before_the_verdict(tmp_path, course, said):
    recording = _load(tmp_path, course)
    assert recording.findings[0].what == "position hardly moves"
    assert said in recording.findings[0].value
    sentence = in_view_of(recording.still, "Nothing is missing.")
    assert sentence.startswith("These data hardly move (position ")
    assert sentence.endswith("As far as they show, nothing is missing.")


@pytest.mark.parametrize(
    "course",
    [
        TIME,
        30.0 * NOISE * np.sin(0.6 * TIME),
        100.0 * NOISE * np.sin(2.0 * np.pi * 12.5 * TIME),
        np.clip(TIME, 6.0, 7.0),
        # Rows of which each is several steps of its sensor on: no row repeats one.
        30.0 * np.round(TIME / 0.004 + 0.2 * np.sin(TIME)),
    ],
)
def test_slow_and_fast_motion_and_long_rests_are_motion(tmp_path, course):
    recording = _load(tmp_path, course)
    assert not recording.findings
    assert in_view_of(recording.still, "Nothing is missing.") == "Nothing is missing."
