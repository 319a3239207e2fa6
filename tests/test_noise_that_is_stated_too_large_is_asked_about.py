"""Nothing is missing within a noise that nobody has: a lack of that size would not show."""

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.sentences import verdict_sentence


@pytest.mark.parametrize(
    ("stated", "asked"),
    [pytest.param("0.0115 deg", False, marks=pytest.mark.slow), ("0.2 deg", True)],
)
def test_it_is_asked_whether_the_map_is_right(tmp_path, stated, asked):
    recorded_axis(tmp_path, ())  # made with 2e-4 rad, which is 0.0115 deg
    described = tmp_path / "map.toml"
    text = described.read_text(encoding="utf-8")
    text = text.replace('column = "angle"', f'column = "angle"\nnoise = "{stated}"')
    described.write_text(text, encoding="utf-8")
    found = diagnose(load_recording(tmp_path / "data.csv", described), declared_axis(), [])
    assert found.search.verdict.kind == "nothing missing"
    assert ("far below the noise" in verdict_sentence(found)) is asked
