"""Which map a diagnosis takes where none is named."""

import pytest

from simpter_hybrid.identification.maps import MAPS, find_map
from simpter_hybrid.problems import InvalidInput


def _written(folder, *names):
    folder.mkdir(exist_ok=True)
    for name in names:
        (folder / name).write_text("", encoding="utf-8")
    return folder


def test_the_one_that_belongs_to_the_model(tmp_path):
    data = _written(tmp_path / "data", "take.csv", "map.toml")
    model = _written(tmp_path / "out", "corrected.toml", "corrected_map.toml") / "corrected.toml"
    assert find_map(None, str(data / "take.csv"), model).name == "corrected_map.toml"


def test_else_the_one_beside_the_recording(tmp_path):
    data = _written(tmp_path / "data", "take.csv", "map.toml")
    model = _written(tmp_path / "out", "emps.toml") / "emps.toml"
    assert find_map(None, str(data / "take.csv"), model) == data / "map.toml"


def test_else_the_shipped_one(tmp_path):
    model = _written(tmp_path, "emps.toml") / "emps.toml"
    assert find_map(None, str(tmp_path / "take.csv"), model) == MAPS / "emps.toml"


def test_where_there_is_none_the_names_that_were_looked_for_are_told(tmp_path):
    model = _written(tmp_path, "rig.toml") / "rig.toml"
    with pytest.raises(InvalidInput) as told:
        find_map(None, str(tmp_path / "data" / "take.csv"), model)
    for file in (tmp_path / "rig_map.toml", tmp_path / "data" / "map.toml"):
        assert str(file) in str(told.value)
