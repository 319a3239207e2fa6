"""Two runs with one ``--out``: the later one is kept under a free name, and says so."""

import threading

from simpter_hybrid import engine
from simpter_hybrid.cli import main
from simpter_hybrid.files.run_directory import (
    RunDirectoryError,
    free_beside,
    run_directory,
    take_name,
)


def test_a_name_taken_during_the_run(tmp_path, monkeypatch, capsys):
    out, simulate = tmp_path / "run", engine.simulate

    def overtaken(*given):
        out.mkdir()
        (out / "trajectory.npz").write_bytes(b"another run")
        return simulate(*given)

    monkeypatch.setattr(engine, "simulate", overtaken)
    assert main(["run", "reduced-clutch-1", "--quiet", "--no-report", "--out", str(out)]) == 2
    assert (out / "trajectory.npz").read_bytes() == b"another run"
    assert (tmp_path / "run-2" / "summary.json").exists()
    printed = capsys.readouterr()
    assert printed.err.count("\n") == 1
    assert f"{out} was taken by another run meanwhile; this one is in {out}-2" in printed.err
    assert printed.out.endswith(f"files in {out}-2\n")


def test_of_many_that_end_at_once_one_takes_the_name_and_the_others_are_refused(tmp_path):
    ready, refused = threading.Barrier(8), []

    def end(k):
        partial = tmp_path / f".run.{k}.partial"
        partial.mkdir()
        (partial / "trajectory.npz").write_text(str(k))
        ready.wait()
        try:
            take_name(partial, tmp_path / "run", overwrite=False)
        except RunDirectoryError:
            refused.append(str(k))

    threads = [threading.Thread(target=end, args=(k,)) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    taken = (tmp_path / "run" / "trajectory.npz").read_text()
    assert sorted([*refused, taken]) == list("01234567")


def test_two_threads_that_save_to_one_target_leave_each_other_alone(tmp_path):
    both, kept = threading.Barrier(2, timeout=20.0), []

    def save(k):
        with run_directory(tmp_path / "run", otherwise=free_beside) as partial:
            (partial / "trajectory.npz").write_text(str(k))
            both.wait()
            kept.append((partial / "trajectory.npz").read_text())
            both.wait()

    threads = [threading.Thread(target=save, args=(k,)) for k in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(kept) == ["0", "1"]
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["run", "run-2"]
