"""A clutch whose command is not in the map would be driven by what is not its own."""

import numpy as np
import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

TIME = 0.002 * np.arange(400)
UNITS = {"position": ("rad", "measured"), "command": ("V", "input"), "force": ("N", "input")}
NAMES = ["position_1", "position_2", *(f"command_{k}" for k in range(1, 5)), "force_x", "force_y"]


def bench(folder, names, resting=0):
    """What a diagnosis needs of four runs with these channels; the first of them rest."""
    rows = [",".join(["run", "t", *names])]
    for run in range(4):
        for t in TIME:
            cells = [
                0.1 * (run >= resting) * np.sin(5 * t) + 1.0 if name.startswith("position") else 0.0
                for name in names
            ]
            rows.append(f"{run},{t:.3f}," + ",".join(f"{x:.6f}" for x in cells))
    text = '[time]\ncolumn = "t"\nunit = "s"\n[runs]\nboundaries = ["run"]\n'
    for name in names:
        unit, role = UNITS[name.rpartition("_")[0]]
        text += (
            f'[channels.{name}]\ncolumn = "{name}"\nunit = "{unit}"\nsign = 1\nrole = "{role}"\n'
        )
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(text, encoding="utf-8")
    recording = load_recording(folder / "data.csv", folder / "map.toml")
    return bench_of(recording, load(find_model("robot")), groups_of(recording))


@pytest.mark.parametrize("gone", ["command_4", "command_3", "position_2"])
def test_one_that_is_missing_is_named(tmp_path, gone):
    with pytest.raises(InvalidInput, match=rf"channels\.{gone}: missing"):
        bench(tmp_path, [name for name in NAMES if name != gone])


def test_one_more_than_the_device_has_is_remarked(tmp_path):
    (said,) = bench(tmp_path, [*NAMES, "command_5"]).remarks
    assert said.what.startswith("nothing uses the channel command_5")
    assert bench(tmp_path, NAMES).remarks == ()


def test_runs_that_rest_are_refused(tmp_path):
    with pytest.raises(InvalidInput, match=r"split\.fit: no run of it moves"):
        bench(tmp_path, NAMES, resting=2)
