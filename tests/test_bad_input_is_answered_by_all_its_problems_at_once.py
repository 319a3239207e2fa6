"""Every broken scenario or argument: exit code 2, all problems and places, nothing written."""

import re
import tomllib
from pathlib import Path

import pytest

from simpter_hybrid.cli import main

HERE = Path(__file__).parent
SOUND = (HERE / "sound_scenario.toml").read_text()
TABLE = tomllib.loads((HERE / "broken_scenarios.toml").read_text())
FILES, ARGUMENTS = TABLE["file"], TABLE["arguments"]

LINE = re.compile(r"(?P<where>.+?): (?P<what>.*), got (?P<value>.*?); expected (?P<right>.+)")


def run(arguments):
    """Exit code of one command line."""
    try:
        return main(arguments)
    except SystemExit as end:
        return end.code


def line_of(text, key):
    """Number of the line that begins with ``key`` or holds it; 1 for ''; ``2:key``: the second."""
    if key.startswith("2:"):
        first = line_of(text, key[2:])
        rest = "\n" * first + text.split("\n", first)[first]
        return line_of(rest, key[2:])
    lines = text.split("\n")
    starting = [i for i, line in enumerate(lines, 1) if line.startswith(key)]
    holding = [i for i, line in enumerate(lines, 1) if key in line]
    return (starting or holding)[0] if key else 1


def test_the_scenario_that_is_broken_below_is_sound(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sound.toml").write_text(SOUND)
    assert run(["check", "sound.toml"]) == 0, capsys.readouterr().err


def test_there_are_sixty_or_more():
    assert len(FILES) + len(ARGUMENTS) >= 60
    assert len({case["name"] for case in FILES + ARGUMENTS}) == len(FILES) + len(ARGUMENTS)


@pytest.mark.parametrize("case", FILES, ids=[case["name"] for case in FILES])
def test_a_broken_file(case, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    text = SOUND
    for old, new in case["change"]:
        assert old in text
        text = text.replace(old, new, 1)
    (tmp_path / "s.toml").write_text(text)

    assert run(["run", "s.toml", "--json"]) == 2

    out, err = capsys.readouterr()
    assert "Traceback" not in err
    *lines, last = err.strip().split("\n")
    assert last.endswith("nothing was written")
    assert [p.name for p in tmp_path.iterdir()] == ["s.toml"]
    assert out.count('"where"') == len(lines)
    found = [LINE.fullmatch(line) for line in lines]
    assert all(found), err
    wanted = list(case["say"])
    for match in found:
        hit = next(
            (
                w
                for w in wanted
                if w[1] in match["what"]
                and w[2] in match["right"]
                and match["where"].partition(": ")[0] in (f"s.toml:{line_of(text, w[0])}", w[0])
            ),
            None,
        )
        assert hit is not None, f"unexpected: {match[0]}"
        wanted.remove(hit)
    assert not wanted


@pytest.mark.parametrize("case", ARGUMENTS, ids=[case["name"] for case in ARGUMENTS])
def test_broken_arguments(case, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "s.toml").write_text(SOUND)
    (tmp_path / "used").mkdir()
    (tmp_path / "used" / "notes.txt").write_text("mine")

    assert run([a.replace("FILE", "s.toml") for a in case["given"]]) == 2

    err = capsys.readouterr().err
    assert "Traceback" not in err
    for part in case["say"]:
        assert part in err
    assert sorted(p.name for p in tmp_path.iterdir()) == ["s.toml", "used"]
    assert (tmp_path / "used" / "notes.txt").read_text() == "mine"
