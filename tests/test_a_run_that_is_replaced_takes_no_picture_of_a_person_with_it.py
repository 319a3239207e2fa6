from pathlib import Path

import pytest

import simpter_hybrid as sh
from simpter_hybrid.cli import main
from simpter_hybrid.files.run_directory import FILES
from simpter_hybrid.plots import figures

RUN = ["run", "testbed-step-0-8", "--no-report", "--quiet", "--out"]


def test_a_picture_of_a_person_stays(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    out = tmp_path / "out"
    assert main([*RUN, str(out)]) == 0
    (out / "setup_photo.png").write_bytes(b"of a person")
    assert main([*RUN, str(out), "--force"]) == 2
    assert "setup_photo.png beside the run, which would be lost" in capsys.readouterr().err
    assert (out / "setup_photo.png").read_bytes() == b"of a person"


def test_all_pictures_of_a_run_are_known_as_its_own() -> None:
    drawn = figures(sh.run(sh.load("line-y24")))
    assert {f"{name}.png" for name in drawn} <= FILES
