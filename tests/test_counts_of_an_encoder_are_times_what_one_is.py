"""A column of counts with `times` is the same recording as one of degrees."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

COUNT = 360.0 / 8192.0
COUNTED = MAP.replace(
    'unit = "deg"', f'unit = "deg"\ntimes = {COUNT!r}\nlimits = ["-9 deg", "9 deg"]'
)


def _loaded(folder, described, one=1.0):
    rows = ["take,ms,angle,torque"]
    for k in range(180):
        rows.append(f"{k // 60},{4 * (k % 60)},{round(100 * np.sin(0.1 * k)) * one!r},{k % 5}")
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_values_limits_and_what_is_written_are_those_of_degrees(tmp_path):
    counted = _loaded(tmp_path, COUNTED)
    degrees = _loaded(tmp_path, MAP, COUNT)
    for a, b in zip(counted.runs, degrees.runs, strict=True):
        assert a.channels["position"] == pytest.approx(b.channels["position"], abs=1e-15)
    channel = counted.channels["position"]
    assert channel.limits == pytest.approx((-9.0 / COUNT, 9.0 / COUNT))
    assert channel.written(-np.radians(4.5)) == "4.5 deg"
    assert channel.written_change(-np.radians(4.5)) == "4.5 deg"


@pytest.mark.parametrize("times", ["0", "-2", '"many"'])
def test_what_is_no_positive_number_is_refused(tmp_path, times):
    with pytest.raises(InvalidInput, match="times"):
        _loaded(tmp_path, MAP.replace('unit = "deg"', f'unit = "deg"\ntimes = {times}'))


def test_an_unknown_unit_is_answered_with_the_key(tmp_path):
    with pytest.raises(InvalidInput, match="times = what one is"):
        _loaded(tmp_path, MAP.replace('unit = "deg"', 'unit = "count"'))
