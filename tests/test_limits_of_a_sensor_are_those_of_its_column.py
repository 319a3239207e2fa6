"""A limit is where the column ends, whatever sign and offset make of it; of inputs as well."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording

TIME = np.arange(0.0, 2.0, 0.004)
TORQUE = np.clip(np.sin(5.0 * TIME), -1.0, 0.7)
ANGLE = 30.0 * np.sin(3.0 * TIME)


def _saturated(folder, described):
    rows = [f"0,{1e3 * t:.1f},{a:.4f},{u:.4f}" for t, a, u in zip(TIME, ANGLE, TORQUE, strict=True)]
    (folder / "data.csv").write_text("\n".join(["take,ms,angle,torque", *rows]), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    read = load_recording(folder / "data.csv", folder / "map.toml")
    return read, [f for f in read.findings if "saturated" in f.what]


@pytest.mark.parametrize("sign", [1, -1])
def test_of_an_input_with_sign_and_offset(tmp_path, sign):
    own = f'sign = {sign}\nlimits = ["-2 lbf*in", "0.7 lbf*in"]\noffset = "0.3 lbf*in"\n'
    head, torque = MAP.split("[channels.torque]")
    described = f"{head}[channels.torque]{torque.replace('sign = 1', own)}"
    _, (found,) = _saturated(tmp_path, described)
    assert found.what == f"torque saturated in {(TORQUE >= 0.7).sum()} samples, the first here"
    assert (found.value, found.right) == ("0.7 lbf*in", "between -2 and 0.7 lbf*in")


def test_of_counts_they_are_told_in_the_unit_of_what_counts(tmp_path):
    head, torque = MAP.split("[channels.torque]")
    own = 'times = 0.01\nlimits = ["-0.02 lbf*in", "0.007 lbf*in"]\n'
    described = f"{head}[channels.torque]{torque.replace('sign = 1', f'sign = 1{chr(10)}{own}')}"
    _, (found,) = _saturated(tmp_path, described)
    assert (found.value, found.right) == ("0.007 lbf*in", "between -0.02 and 0.007 lbf*in")


def test_of_a_measured_angle_whose_sign_is_turned(tmp_path):
    described = MAP.replace("may_rest = true", 'limits = ["-40 deg", "29 deg"]\nmay_rest = true')
    read, (found,) = _saturated(tmp_path, described)
    assert found.value.endswith(" deg")
    assert float(found.value.split()[0]) >= 29.0
    # What is measured there is not compared, whatever sign the map gives it.
    assert np.array_equal(read.runs[0].compared("position"), ANGLE < 29.0)
