"""No bytes, blank lines or a header alone: one line that says so, whatever columns are missing."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput


def _refused(folder, name):
    (folder / "map.toml").write_text(MAP, encoding="utf-8")
    with pytest.raises(InvalidInput) as caught:
        load_recording(folder / name, folder / "map.toml")
    (problem,) = caught.value.problems
    return problem


@pytest.mark.parametrize(
    ("content", "what"),
    [
        ("", "the file is empty"),
        ("\n \n", "the file is empty"),
        ("take,ms,angle,torque\n", "the file has no rows"),
        ("time,x\n", "the file has no rows"),
    ],
)
def test_an_empty_text_is_refused_once(tmp_path, content, what):
    (tmp_path / "data.csv").write_text(content, encoding="utf-8")
    assert _refused(tmp_path, "data.csv").what == what


@pytest.mark.parametrize("names", [(), ("x",), ("take", "ms", "angle", "torque")])
def test_arrays_without_a_value_are_refused_once(tmp_path, names):
    np.savez(tmp_path / "data.npz", **{name: np.zeros(0) for name in names})
    assert _refused(tmp_path, "data.npz").what == "the file is empty"
