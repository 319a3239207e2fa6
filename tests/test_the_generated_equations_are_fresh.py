"""The committed generated modules are what the derivations give today, and a change is noticed."""

import re

import sympy

from derivations import modules, provenance
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
    assert "-    out[0] = 3.0*alpha" in out
    assert "+    out[0] = 2.0*alpha" in out


def test_changed_sources_with_unchanged_equations_are_noticed(monkeypatch, capsys):
    monkeypatch.setattr(provenance, "source_hash", lambda: "0" * 16)
    assert main(["--check"]) == 1
    assert "the banner names older sources" in capsys.readouterr().out


def test_another_sympy_with_the_same_equations_is_not_stale(monkeypatch):
    monkeypatch.setattr(sympy, "__version__", "0.0")
    assert modules.stale() == []


def test_the_banner_says_how_to_regenerate_and_holds_no_date_and_no_path():
    for text in modules.texts().values():
        banner, body = provenance.split_banner(text)
        assert "python -m derivations" in banner
        assert f"sha256 {provenance.source_hash()}" in banner
        assert f"sympy {sympy.__version__}" in banner
        assert re.search(r"\d{4}-\d\d|\d:\d\d|/home|/tmp", banner) is None
        assert body.startswith('"""PTER\'s')
