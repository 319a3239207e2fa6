"""A wrapped angle is refused as one that jumps, unless the map says after how much it wraps."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

MAP = """
[time]
column = "t"
unit = "s"
[channels.position]
column = "angle"
unit = "deg"
sign = -1
role = "measured"
WRAPS
"""
TURNED = 40.0 * np.arange(200) - 0.12 * np.arange(200) ** 2


def _recorded(folder, wraps, blank=()):
    cells = [f"{angle % 360.0:.6f}" if k not in blank else "" for k, angle in enumerate(TURNED)]
    lines = ["t,angle", *(f"{0.01 * k:.2f},{cell}" for k, cell in enumerate(cells))]
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(MAP.replace("WRAPS", wraps), encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_it_goes_on_beyond_a_turn(tmp_path):
    (run,) = _recorded(tmp_path, 'wraps = "360 deg"').runs
    assert run.channels["position"] == pytest.approx(-np.deg2rad(TURNED), abs=1e-6)


def test_without_a_word_of_the_map_it_jumps_and_the_key_is_told(tmp_path):
    with pytest.raises(InvalidInput, match=r'wraps = "360 deg" in the map'):
        _recorded(tmp_path, "")


def test_a_row_without_a_number_parts_no_turn_from_another(tmp_path):
    left_out = 'wraps = "360 deg"\n[table]\nmissing = "left out"'
    (run,) = _recorded(tmp_path, left_out, blank=(50, 51)).runs
    seen = np.delete(TURNED, (50, 51))
    assert run.channels["position"] == pytest.approx(-np.deg2rad(seen), abs=1e-6)


def test_over_lost_rows_it_goes_on_as_fast_as_before_them(tmp_path):
    turned = 125.0 * np.arange(200)
    cells = [f"{0.01 * k:.2f},{angle % 360.0:.6f}" for k, angle in enumerate(turned) if k != 90]
    (tmp_path / "data.csv").write_text("\n".join(["t,angle", *cells]), encoding="utf-8")
    described = MAP.replace("WRAPS", 'wraps = "360 deg"')
    (tmp_path / "map.toml").write_text(described, encoding="utf-8")
    (run,) = load_recording(tmp_path / "data.csv", tmp_path / "map.toml").runs
    seen = np.deg2rad(np.delete(turned, 90))
    assert run.channels["position"] == pytest.approx(-seen, abs=1e-6)


def test_time_that_stands_is_told_as_such(tmp_path):
    rows = [f"{0.01 * (k - (k > 80)):.2f},{a % 360.0:.6f}" for k, a in enumerate(TURNED) if k != 83]
    (tmp_path / "data.csv").write_text("\n".join(["t,angle", *rows]), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP.replace("WRAPS", 'wraps = "360 deg"'), encoding="utf-8")
    with pytest.raises(InvalidInput, match="time stands still"):
        load_recording(tmp_path / "data.csv", tmp_path / "map.toml")


def test_each_run_begins_where_its_file_has_it(tmp_path):
    one = [f"{0.01 * k:.2f},{angle % 360.0:.6f}" for k, angle in enumerate(TURNED)]
    rows = [f"{take},{row}" for take in (1, 2) for row in one]
    (tmp_path / "data.csv").write_text("\n".join(["take,t,angle", *rows]), encoding="utf-8")
    described = MAP.replace("WRAPS", 'wraps = "360 deg"') + '[runs]\nboundaries = ["take"]\n'
    (tmp_path / "map.toml").write_text(described, encoding="utf-8")
    one, other = load_recording(tmp_path / "data.csv", tmp_path / "map.toml").runs
    assert one.channels["position"] == pytest.approx(other.channels["position"], abs=1e-12)


@pytest.mark.parametrize(
    ("wraps", "said"),
    [('"10 deg"', "goes on beyond"), ('"0 deg"', "above zero"), ('"-9 deg"', "above zero")],
)
def test_a_turn_that_is_none_is_refused(tmp_path, wraps, said):
    with pytest.raises(InvalidInput, match=said):
        _recorded(tmp_path, f"wraps = {wraps}")


def test_what_ends_does_not_begin_anew(tmp_path):
    with pytest.raises(InvalidInput, match="ends and begins anew"):
        _recorded(tmp_path, 'wraps = "360 deg"\nlimits = ["0 deg", "360 deg"]')


SHARED = """
[time]
column = "t"
unit = "s"
[runs]
boundaries = ["joint"]
"""
CHANNEL = """
[channels.position_{0}]
column = "angle"
unit = "deg"
sign = 1
role = "measured"
wraps = "360 deg"
where = {{column = "joint", equals = {0}}}
"""


def test_each_of_two_channels_of_one_column_goes_on(tmp_path):
    rows = [f"{j},{0.01 * k:.2f},{a % 360.0:.6f}" for j in (1, 2) for k, a in enumerate(TURNED)]
    (tmp_path / "data.csv").write_text("\n".join(["joint,t,angle", *rows]), encoding="utf-8")
    channels = CHANNEL.format(1) + CHANNEL.format(2)
    (tmp_path / "map.toml").write_text(SHARED + channels, encoding="utf-8")
    runs = load_recording(tmp_path / "data.csv", tmp_path / "map.toml").runs
    for k, run in enumerate(runs, 1):
        told = run.channels[f"position_{k}"]
        assert told == pytest.approx(np.deg2rad(TURNED), abs=1e-6)
