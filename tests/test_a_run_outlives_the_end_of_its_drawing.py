"""Ctrl-C or a failure while the report is drawn costs the report, not the run."""

import signal

import pytest

from simpter_hybrid import plots
from simpter_hybrid.cli import main
from simpter_hybrid.progress import Progress


def run(tmp_path, *more):
    return main(["run", "reduced-clutch-1", "--quiet", "--out", str(tmp_path / "run"), *more])


def test_interrupted(tmp_path, monkeypatch):
    def interrupt(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr(plots, "figures", interrupt)
    assert run(tmp_path) == 130
    assert [entry.name for entry in tmp_path.iterdir()] == ["run"]
    assert (tmp_path / "run" / "trajectory.npz").exists()
    assert not (tmp_path / "run" / "report.html").exists()


def test_failed(tmp_path, monkeypatch):
    def fail(*_, **__):
        raise MemoryError

    monkeypatch.setattr(plots, "figures", fail)
    with pytest.raises(MemoryError):
        run(tmp_path)
    assert (tmp_path / "run" / "summary.json").exists()


@pytest.mark.parametrize("name", ["/proc/nothing", "/dev/null/run", "n" * 250])
def test_a_directory_that_cannot_be_made_is_refused_before_the_run(name, tmp_path, capsys):
    assert main(["run", "reduced-clutch-1", "--out", str(tmp_path / name)]) == 2
    assert "cannot be made" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_sigterm_ends_a_run_as_ctrl_c_does(capsys):
    with Progress(1.0) as progress:
        signal.raise_signal(signal.SIGTERM)
        assert progress.interrupted
        with pytest.raises(KeyboardInterrupt):
            progress(0.5)
    assert "keeping what there is" in capsys.readouterr().err
