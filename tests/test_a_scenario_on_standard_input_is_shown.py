"""``simpter show -``: standard input is a file like any other."""

import io

from simpter_hybrid.cli import main
from simpter_hybrid.files.scenario_file import find_scenario


def test_it_is_printed_as_it_was_given(monkeypatch, capsys):
    text = find_scenario("line-y24").read_text(encoding="utf-8")
    given = io.BytesIO(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(given, encoding="utf-8"))
    assert main(["show", "-"]) == 0
    assert capsys.readouterr().out == text


def test_what_is_no_toml_is_refused_with_its_line(monkeypatch, capsys):
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"\nx ="), encoding="utf-8"))
    assert main(["show", "-"]) == 2
    assert "stdin:2: not valid" in capsys.readouterr().err
