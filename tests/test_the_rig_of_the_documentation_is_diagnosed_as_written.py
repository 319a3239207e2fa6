"""Model and map of docs/diagnose.md, taken from the page, fit each other and a recording."""

import re
from pathlib import Path

import numpy as np

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.maps import find_map
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording

PAGE = Path(__file__).parents[1] / "docs" / "diagnose.md"


def test_the_two_files_of_the_page(tmp_path):
    model, described = re.findall(r"```toml\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S)
    (tmp_path / "slide.toml").write_text(model, encoding="utf-8")
    (tmp_path / "slide_map.toml").write_text(described, encoding="utf-8")
    rows = ["trial,kind,time_ms,slide_mm,load_N"]
    for trial in range(6):
        waves = [np.sin(0.05 * k + trial) for k in range(200)]
        rows += [f"{trial},{'ABC'[trial // 2]},{5 * k},{w},{w}" for k, w in enumerate(waves)]
    data = tmp_path / "slide.csv"
    data.write_text("\n".join(rows), encoding="utf-8")
    declared = load(tmp_path / "slide.toml")
    recording = load_recording(data, find_map(None, str(data), tmp_path / "slide.toml"))
    bench = bench_of(recording, declared, groups_of(recording))
    assert {k: len(v) for k, v in bench.parts.items()} == {"fit": 2, "select": 2, "report": 2}
    assert bench.predictor.rig.template(declared).device.mass == 2.0
