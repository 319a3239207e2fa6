"""Two columns of a map that were swapped: a search from there would take long and find nothing."""

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput


def test_swapped_columns_are_asked_about(tmp_path):
    recorded_axis(tmp_path, ())
    described = (tmp_path / "map.toml").read_text(encoding="utf-8")
    swapped = described.replace('"angle"', '"?"').replace('"torque"', '"angle"')
    (tmp_path / "map.toml").write_text(swapped.replace('"?"', '"torque"'), encoding="utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    with pytest.raises(InvalidInput, match="errs more than if nothing had changed"):
        diagnose(recording, declared_axis())
