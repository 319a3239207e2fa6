"""What rests throughout tells nothing of friction: no split may rely on it."""

import numpy as np
import pytest
from axis_recordings import MAP, MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput


@pytest.mark.parametrize(("resting", "part"), [(0, "fit"), (1, "select"), (2, "report")])
def test_a_part_without_motion_is_refused(tmp_path, resting, part):
    draw, rows = np.random.default_rng(3), ["take,ms,angle,torque"]
    for take in range(3):
        size = 0.0 if take == resting else 10.0
        for k in range(300):
            angle = size * np.sin(0.05 * k) + 0.01 * draw.standard_normal()
            rows.append(f"{take},{4 * k},{angle:.5f},{np.sin(0.05 * k):.4f}")
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    split = '[split]\nfit = ["take 0"]\nselect = ["take 1"]\nreport = ["take 2"]\n'
    described = MAP[: MAP.index("[split]")] + split + MAP[MAP.index("[channels.position]") :]
    (tmp_path / "map.toml").write_text(described, encoding="utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    with pytest.raises(InvalidInput, match=rf"split\.{part}: no run of it moves"):
        bench_of(recording, parse(MODEL), groups_of(recording))
