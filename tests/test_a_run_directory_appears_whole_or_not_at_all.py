"""Atomic writes, no accidental overwriting, nothing of others deleted."""

import pytest
from sampled_runs import oscillator

from simpter_hybrid.files.run_directory import RunDirectoryError
from simpter_hybrid.files.storage import save


def test_a_failure_leaves_nothing(tmp_path):
    def fail(_):
        raise RuntimeError("disk full")

    with pytest.raises(RuntimeError, match="disk full"):
        save(oscillator(), tmp_path / "run", also=fail)
    assert list(tmp_path.iterdir()) == []


def test_a_failure_keeps_the_run_that_was_there(tmp_path):
    save(oscillator(), tmp_path / "run")
    before = (tmp_path / "run" / "trajectory.npz").read_bytes()

    def interrupt(partial):
        (partial / "trajectory.npz").write_bytes(b"half")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        save(oscillator(), tmp_path / "run", overwrite=True, also=interrupt)
    assert (tmp_path / "run" / "trajectory.npz").read_bytes() == before
    assert [entry.name for entry in tmp_path.iterdir()] == ["run"]


def test_an_existing_run_is_replaced_only_on_demand(tmp_path):
    save(oscillator(), tmp_path / "run")
    with pytest.raises(RunDirectoryError, match="not empty"):
        save(oscillator(), tmp_path / "run")
    save(oscillator(), tmp_path / "run", "name = 'b'\n", overwrite=True)
    assert (tmp_path / "run" / "scenario.toml").read_text() == "name = 'b'\n"


def test_a_directory_that_holds_no_run_is_never_replaced(tmp_path):
    (tmp_path / "thesis.txt").write_text("years of work")
    with pytest.raises(RunDirectoryError, match="holds no run"):
        save(oscillator(), tmp_path, overwrite=True)
    assert (tmp_path / "thesis.txt").exists()


def test_an_empty_directory_may_be_used(tmp_path):
    (tmp_path / "run").mkdir()
    save(oscillator(), tmp_path / "run")
    assert (tmp_path / "run" / "summary.json").exists()


def test_a_file_is_refused(tmp_path):
    (tmp_path / "run").write_text("")
    with pytest.raises(RunDirectoryError, match="is a file"):
        save(oscillator(), tmp_path / "run")


def test_what_no_run_writes_is_not_replaced_with_it(tmp_path):
    save(oscillator(), tmp_path / "run")
    (tmp_path / "run" / "notes.txt").write_text("seen on Tuesday")
    with pytest.raises(RunDirectoryError, match=r"notes\.txt beside the run"):
        save(oscillator(), tmp_path / "run", overwrite=True)
    assert (tmp_path / "run" / "notes.txt").exists()


def test_a_module_that_a_run_left_is_replaced_unless_it_was_changed_since(tmp_path):
    def copied(partial):
        (partial / "film.py").write_text("SIZE = 1\n")

    for _ in range(2):
        save(oscillator(), tmp_path / "run", overwrite=True, also=copied)
    (tmp_path / "run" / "film.py").write_text("SIZE = 2\n")
    with pytest.raises(RunDirectoryError, match=r"film\.py beside the run"):
        save(oscillator(), tmp_path / "run", overwrite=True, also=copied)
    assert (tmp_path / "run" / "film.py").read_text() == "SIZE = 2\n"
