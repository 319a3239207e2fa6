import pytest

from simpter_hybrid.cli import main
from simpter_hybrid.identification.rigs.scenario_runner import threads


@pytest.mark.parametrize("told", ["two", "-1", "1.5"])
def test_before_anything_is_read(told, monkeypatch, capsys, tmp_path):
    monkeypatch.setenv("SIMPTER_JOBS", told)
    monkeypatch.chdir(tmp_path)
    assert main(["diagnose", "nothing.csv", "--model", "emps"]) == 2
    assert f"SIMPTER_JOBS: no number of threads, got {told}" in capsys.readouterr().err


@pytest.mark.parametrize(("told", "count"), [("3", 3), (" 1 ", 1)])
def test_a_number_is_taken(told, count, monkeypatch):
    monkeypatch.setenv("SIMPTER_JOBS", told)
    assert threads() == count


@pytest.mark.parametrize("told", ["", "0"])
def test_none_is_the_usual_one(told, monkeypatch):
    monkeypatch.setenv("SIMPTER_JOBS", told)
    assert threads() in (1, 2)
