"""Results of different sweeps are never mixed, and nobody's files are written over."""

import json

import pytest

pytest.importorskip("llvmlite")
import simpter_hybrid as sh
from simpter_hybrid.problems import InvalidInput

NAME, VARY = "reduced-clutch-1", {"run.t_end": ["0.1 s", "0.2 s"]}


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    out = tmp_path_factory.mktemp("swept") / "s"
    sh.sweep(NAME, VARY, out)
    return out


@pytest.mark.parametrize(
    ("name", "vary", "more", "differs"),
    [
        (NAME, {"run.t_end": ["0.1 s", "0.3 s"]}, {}, "(other design)"),
        (NAME, {"run.t_end": ["0.1 s"]}, {}, "(other cases, design)"),
        ("reduced-clutch-2", VARY, {}, "(other name, scenario)"),
        (NAME, VARY, {"overrides": ["clutch.delay=1 ms"]}, "(other scenario)"),
        (NAME, VARY, {"step": "2 ms"}, "(other step_s)"),
        (NAME, VARY, {"engine": "reference"}, "(other engine)"),
    ],
)
def test_another_sweep(swept, name, vary, more, differs):
    before = {f: f.read_bytes() for f in swept.rglob("*.*")}
    with pytest.raises(InvalidInput) as caught:
        sh.sweep(name, vary, swept, **more)
    assert f"holds a different sweep {differs}" in str(caught.value)
    assert before == {f: f.read_bytes() for f in swept.rglob("*.*")}


def test_results_of_another_version_of_the_program(swept, tmp_path):
    about = json.loads((swept / "sweep.json").read_text()) | {"program": "0" * 64}
    (tmp_path / "sweep.json").write_text(json.dumps(about))
    with pytest.raises(InvalidInput, match="computed by another version of the program"):
        sh.sweep(NAME, VARY, tmp_path)


@pytest.mark.parametrize("file", ["notes.txt", "sweep.json"])
def test_somebodys_files(tmp_path, file):
    (tmp_path / file).write_text("mine")
    with pytest.raises(InvalidInput, match=r"--out: holds"):
        sh.sweep(NAME, VARY, tmp_path)
    assert [f.name for f in tmp_path.iterdir()] == [file]


def test_a_damaged_result_is_computed_again(tmp_path):
    table = sh.sweep(NAME, VARY, tmp_path)
    file = tmp_path / "cases" / f"{table.records[1].case}.json"
    whole = file.read_bytes()
    file.write_bytes(whole[:50])
    assert sh.sweep(NAME, VARY, tmp_path).records == table.records
    assert file.read_bytes() == whole
