"""docs/your-own-device.md: its files, its commands with what they print, its Python."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from simpter_hybrid.cli import main

PAGE = (Path(__file__).parent.parent / "docs/your-own-device.md").read_text()
FILES = re.findall(r"^`(bead\.\w+)`:\n\n```\w+\n(.*?)^```", PAGE, re.M | re.S)
COMMANDS = re.findall(r"^\$ (.*)\n((?:(?!\$ |```).*\n)*)", PAGE, re.M)
CODE = re.findall(r"\n\n```python\n((?:from|import) (?!dataclasses).*?)^```", PAGE, re.M | re.S)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    for name, text in FILES:
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def alike(text):
    """Lines with all numbers cut to five digits (the last ones depend on the processor)."""
    cut = re.sub(r"\d+\.?\d*(e-\d+)?", lambda m: f"{float(m[0]):.5g}", text)
    return re.sub(r"\d+ steps|to [\d.e-]+ of", "#", cut).splitlines()


def test_its_commands_print_what_stands_there(folder, capsys):
    assert [name for name, _ in FILES] == ["bead.py", "bead.toml"]
    assert [command.split()[1] for command, _ in COMMANDS] == ["check", "run", "explain", "compare"]
    for command, printed in COMMANDS[:3]:
        assert main(command.split()[1:]) == 0
        said = alike(capsys.readouterr().out)
        assert [line for line in alike(printed) if line not in said] == []


def test_its_python_does_what_the_comments_say(folder):
    assert len(CODE) == 3
    run = subprocess.run(
        [sys.executable, "-c", "\n".join(CODE)], capture_output=True, text=True, check=True
    )
    lines = run.stdout.splitlines()
    assert lines[0] == "[]"
    assert [line.split()[1:] for line in lines[1:3]] == [["switched"], ["slip", "stop"]]
