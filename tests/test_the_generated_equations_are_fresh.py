"""The committed generated modules are what the derivations give today, and a change is noticed."""

from derivations import modules
from derivations.__main__ import main


def test_the_committed_modules_are_fresh(capsys):
    assert modules.stale() == []
    assert main(["--check"]) == 0
    assert capsys.readouterr().out == ""


def test_a_changed_equation_gives_a_diff_and_a_failure(tmp_path, monkeypatch, capsys):
    changed = {}
    for path, text in modules.texts().items():
        copy = tmp_path / "simpter_hybrid" / "devices" / path.name
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(text.replace("2.0*alpha", "3.0*alpha"), encoding="utf-8")
        changed[copy] = text
    monkeypatch.setattr(modules, "texts", lambda: changed)
    assert main(["--check"]) == 1
    out = capsys.readouterr().out
    assert "-    out[0] = 3.0*alpha" in out and "+    out[0] = 2.0*alpha" in out


def test_the_banner_names_no_date_and_no_path():
    for text in modules.texts().values():
        banner = "".join(text.splitlines(keepends=True)[:4])
        assert banner.count("\n") == 4 and "sha256" in banner and "sympy" in banner
        assert "/tmp" not in banner and "20" not in banner.split("sha256")[0]
