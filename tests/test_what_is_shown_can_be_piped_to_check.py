"""``simpter show NAME | simpter check -``: standard input is a file like any other."""

import io

import pytest

from simpter_hybrid.cli import main


def given(monkeypatch, raw):
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(raw), encoding="utf-8"))


def test_what_show_prints_is_sound(monkeypatch, capsys):
    assert main(["show", "line-y24"]) == 0
    given(monkeypatch, capsys.readouterr().out.encode())
    assert main(["check", "-", "--set", "controller.rate=30 Hz"]) == 0
    assert "sampled every 0.0333333 s" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("raw", "said"),
    [(b'x = "\xff"', "stdin:1: not UTF-8"), (b"\nx =", "stdin:2: not valid"), (b"", "[run]")],
)
def test_what_is_wrong_with_it_is_said_with_its_line(raw, said, monkeypatch, capsys):
    given(monkeypatch, raw)
    assert main(["check", "-"]) == 2
    assert said in capsys.readouterr().err
