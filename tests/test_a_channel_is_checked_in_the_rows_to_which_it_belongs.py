"""Another sensor may stand in the same column in rows of another mode."""

from pathlib import Path

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.recording import Recording, load_recording
from simpter_hybrid.problems import InvalidInput

MAP = """
[time]
column = "t"
unit = "s"
[runs]
boundaries = ["run"]
[channels.position]
column = "q"
unit = "rad"
role = "measured"
sign = 1
"""
IN_MODE_1 = 'where = {column = "mode", equals = 1}\n'
FORCE = """
[channels.force]
column = "f"
unit = "N"
role = "measured"
sign = 1
"""
TIME, MODE = 0.01 * np.arange(600), np.where(np.arange(600) < 150, 1, 2)


def recorded(
    folder: Path, text: str, position: np.ndarray, force: np.ndarray | None = None
) -> Recording:
    force = np.zeros(600) if force is None else force
    rows = [
        f"{run},{m},{t:.2f},{q:.9f},{f:.6f}"
        for run in (1, 2, 3)
        for m, t, q, f in zip(MODE, TIME, position + 0.1 * run, force, strict=True)
    ]
    (folder / "data.csv").write_text("\n".join(["run,mode,t,q,f", *rows]), encoding="utf-8")
    (folder / "map.toml").write_text(text, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def swing() -> np.ndarray:
    return np.sin(TIME) + 1e-5 * np.random.default_rng(0).normal(size=TIME.size)


def test_rows_that_repeat_where_it_does_not_apply_are_no_fault(tmp_path: Path) -> None:
    every_second = swing()[(np.arange(600) // 2) * 2]
    position = np.where(MODE == 2, every_second, swing())
    with pytest.raises(InvalidInput, match="repeats the row before"):
        recorded(tmp_path, MAP, position)
    assert recorded(tmp_path, MAP + IN_MODE_1, position).findings == ()


def test_far_values_where_it_does_not_apply_are_no_outliers(tmp_path: Path) -> None:
    force = np.random.default_rng(1).normal(size=600)
    force[400] = 1e4
    told = [f.what for f in recorded(tmp_path, MAP + FORCE, swing(), force).findings]
    assert any("far outside all else" in what for what in told)
    assert recorded(tmp_path, MAP + FORCE + IN_MODE_1, swing(), force).findings == ()


def test_a_sensor_that_is_dead_where_it_applies_is_told(tmp_path: Path) -> None:
    force = np.where(MODE == 1, 5.0, np.sin(TIME))
    told = recorded(tmp_path, MAP + FORCE + IN_MODE_1, swing(), force).findings
    assert [f.what for f in told] == 3 * ["force never changes"]
    assert [f.row for f in told] == [0, 600, 1200]
