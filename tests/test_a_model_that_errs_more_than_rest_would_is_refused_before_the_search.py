"""Two columns of a map that were swapped: a search from there would take long and find nothing."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis
from toy_rig import toy_replay

from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.residual import over_rest
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput


def test_swapped_columns_are_asked_about(tmp_path):
    recorded_axis(tmp_path, ())
    described = (tmp_path / "map.toml").read_text(encoding="utf-8")
    swapped = described.replace('"angle"', '"?"').replace('"torque"', '"angle"')
    (tmp_path / "map.toml").write_text(swapped.replace('"?"', '"torque"'), encoding="utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    with pytest.raises(InvalidInput, match="errs more than if nothing had changed") as refused:
        diagnose(recording, declared_axis())
    assert "of factors on what" not in str(refused.value)
    assert "times as declared" not in str(refused.value)  # with a huge inertia it only rests
    assert "are the columns of torque and position exchanged? So" in str(refused.value)
    assert "where its weight hangs" in str(refused.value)  # the axis has one


def test_runs_may_be_compared_by_different_channels():
    runs = [toy_replay("a", 1), toy_replay("b", 2)]
    runs[1] = replace(runs[1], observed={"speed": runs[1].observed["torque"]})
    seen = [next(iter(r.observed.values())).values for r in runs]
    # From the measured value twice as far off as the first one is, and three times.
    far = [v + k * (v - v[0]) for k, v in zip((2.0, 3.0), seen, strict=True)]
    nothing = np.zeros(0)
    predicted = {"torque": [far[0], nothing], "speed": [nothing, far[1]]}
    assert over_rest(predicted, runs) == pytest.approx(2.0)
