"""From Python: the same verdict, data and files as the command writes."""

import json

import pytest
from axis_recordings import MAP, MODEL, recorded_axis

import simpter_hybrid as simpter
from simpter_hybrid import cli
from simpter_hybrid.problems import InvalidInput


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("axis")
    recorded_axis(folder, [])
    (folder / "axis.toml").write_text(MODEL, encoding="utf-8")
    (folder / "axis_map.toml").write_text(MAP, encoding="utf-8")
    return folder / "data.csv", folder / "axis.toml"


@pytest.fixture(scope="module")
def report(files):
    return simpter.diagnose(*files, sight=False)


@pytest.mark.slow
def test_both_write_the_same_bytes(files, report, tmp_path, capsys):
    report.save(tmp_path / "call")
    said = ["diagnose", str(files[0]), "--model", str(files[1]), "--no-sight", "--quiet"]
    assert cli.main([*said, "--out", str(tmp_path / "command")]) == 0
    assert capsys.readouterr().out.startswith(str(report))
    names = sorted(f.name for f in (tmp_path / "call").iterdir())
    assert names == sorted(f.name for f in (tmp_path / "command").iterdir())
    for name in names:
        ours, theirs = (tmp_path / way / name for way in ("call", "command"))
        assert ours.read_bytes() == theirs.read_bytes(), name
    kept = json.loads((tmp_path / "call" / "diagnosis.json").read_text())
    assert kept["verdict"] == report.data["verdict"]


@pytest.mark.slow
def test_the_corrected_model_runs(report):
    assert simpter.run(report.corrected, engine="compiled").status == "finished"


def test_all_that_is_wrong_is_told_at_once(files):
    with pytest.raises(InvalidInput) as error:
        simpter.diagnose(files[0], files[1], also=["no-such"], effort=-1.0)
    assert [p.where for p in error.value.problems] == ["--also", "--effort"]


def test_one_name_needs_no_list(files):
    with pytest.raises(InvalidInput) as error:
        simpter.diagnose(*files, also="no-such")
    assert [p.value for p in error.value.problems] == ["no-such"]
