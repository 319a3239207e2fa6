"""Files of a run that are cut off, or hold something else, end in no traceback."""

import io
import shutil
import zipfile

import numpy as np
import pytest

import simpter_hybrid
from simpter_hybrid.cli import main
from simpter_hybrid.files.storage import StoredRunError, load


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    run = simpter_hybrid.run("reduced-clutch-1", ["run.t_end=10 ms"])
    return simpter_hybrid.save(run, tmp_path_factory.mktemp("a") / "run")


def empty(file):
    file.write_bytes(b"")


def array(file):
    with file.open("wb") as stream:
        np.save(stream, np.zeros(3))


def without_gates(file):
    out = io.BytesIO()
    with zipfile.ZipFile(file) as old, zipfile.ZipFile(out, "w") as new:
        for name in old.namelist():
            if name != "gate.npy":
                new.writestr(name, old.read(name))
    file.write_bytes(out.getvalue())


def with_events_of_another_kind(file):
    file.write_bytes(file.read_bytes().replace(b'"kind"', b'"sort"'))


def cut_off(file):
    file.write_bytes(file.read_bytes()[:-50])


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        (empty, "cannot be read"), (array, "cannot be read"), (cut_off, "cannot be read"),
        (without_gates, "it holds no gate"), (with_events_of_another_kind, "cannot be read"),
    ],
)  # fmt: skip
def test_a_damaged_trajectory_is_told(saved, damage, said, tmp_path):
    directory = shutil.copytree(saved, tmp_path / "run")
    damage(directory / "trajectory.npz")
    with pytest.raises(StoredRunError, match=f"{said}.*run the scenario again"):
        load(directory)


def test_a_scenario_that_is_no_text_is_told(saved, tmp_path, capsys):
    directory = shutil.copytree(saved, tmp_path / "run")
    (directory / "scenario.toml").write_bytes(b'name = "\xff"\n')
    with pytest.raises(StoredRunError, match=r"scenario\.toml cannot be read.*utf-8"):
        load(directory)
    assert main(["explain", str(directory), "--at", "0.009"]) == 2
    assert "run the scenario again" in capsys.readouterr().err
