"""Independent mistakes of a map and of a model are all told before anything is computed."""

import numpy as np
import pytest
from axis_recordings import MAP, MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput, Problem, together


def test_checks_that_need_no_other_are_all_made():
    def refuse(what):
        raise InvalidInput([Problem("map.toml", what, "wrong", "1", "2")])

    with pytest.raises(InvalidInput) as told:
        together(lambda: refuse("unit"), lambda: None, lambda: refuse("split"))
    assert [p.path for p in told.value.problems] == ["unit", "split"]


def test_split_unit_and_tolerance_are_told_at_once(tmp_path):
    described = MAP.replace('report = ["take 2"]', 'report = ["2"]').replace("lbf*in", "kg")
    (tmp_path / "map.toml").write_text(described, encoding="utf-8")
    rows = [
        f"{take},{4 * k},{10 * np.sin(0.1 * k):.4f},{np.sin(0.1 * k):.4f}"
        for take in range(3)
        for k in range(100)
    ]
    (tmp_path / "data.csv").write_text("\n".join(["take,ms,angle,torque", *rows]), "utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    declared = parse(MODEL[: MODEL.index("[[tolerances]]")])
    with pytest.raises(InvalidInput) as told:
        diagnose(recording, declared)
    told_of = {problem.path for problem in told.value.problems}
    assert {"split.report", "channels.torque.unit", "tolerances"} <= told_of
