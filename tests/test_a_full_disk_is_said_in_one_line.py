"""A disk that takes no more while a run is written: no traceback, exit code 3, no half run."""

import errno

from simpter_hybrid import cli
from simpter_hybrid.files import run_directory, storage


def test_a_full_disk_is_said_in_one_line(tmp_path, monkeypatch, capsys):
    def full(_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(storage, "trajectory_bytes", full)
    out = tmp_path / "run"
    assert cli.main(["run", "reduced-clutch-1", "--no-report", "--quiet", "--out", str(out)]) == 3
    assert "not written: no space left on device" in capsys.readouterr().err
    assert not out.exists()
    assert run_directory.MARK not in {f.name for f in tmp_path.rglob("*")}
