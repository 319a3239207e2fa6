"""``--set path=value`` gives what the file would give had it been written so."""

import re
import tomllib

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.files.tomlfile import parse_toml
from simpter_hybrid.problems import InvalidInput

TEXT = """
title = "a"
[load]
amplitude = "5 lbf"
"dotted.key" = 1
[[effects]]
rise = "1 s"
[[effects]]
rise = "2 s"
"""


@pytest.mark.parametrize(
    ("override", "old", "new"),
    [
        ("load.amplitude=7 lbf", '"5 lbf"', '"7 lbf"'),
        ('load.amplitude="7 lbf"', '"5 lbf"', '"7 lbf"'),
        (" load . amplitude = 7.5 ", '"5 lbf"', "7.5"),
        ("load.amplitude=", '"5 lbf"', '""'),
        ("load.amplitude=a=b", '"5 lbf"', '"a=b"'),
        ("effects.1.rise=3 s", '"2 s"', '"3 s"'),
        ('load."dotted.key"=[1, {x = true}]', "= 1\n", "= [1, {x = true}]\n"),
        ("new.table.key=3", "[load]", "[new.table]\nkey = 3\n[load]"),
    ],
)
def test_the_same_as_edited(override, old, new):
    data, problems = parse_toml(TEXT, "s.toml", [override])
    assert old in TEXT
    assert data == tomllib.loads(TEXT.replace(old, new))
    assert not problems


@pytest.mark.parametrize(
    ("override", "message"),
    [
        ("load", r"--set load: not an override \(no =\)"),
        ("", r"not an override"),
        ("a..b=1", "--set a..b: not an override"),
        ("load.amplitude=[1", "--set load.amplitude: not an override .* not valid TOML"),
        ("title.x=1", '--set title.x: title: not a table, got "a"'),
        ("effects.2.rise=1", "--set effects.2.rise: effects.2: no such element.* below 2"),
        ("effects.-1.rise=1", "no such element"),
        ("effects.rise=1", "no such element"),
    ],
)
def test_what_cannot_be_set_is_a_problem_and_changes_nothing(override, message):
    data, problems = parse_toml(TEXT, "s.toml", [override])
    assert data == tomllib.loads(TEXT)
    with pytest.raises(InvalidInput, match=message):
        problems.raise_if_any()


@pytest.mark.parametrize(
    ("override", "path"),
    [
        ("load.amplitude=1", ("load", "amplitude")),
        ("load={amplitude=1}", ("load", "amplitude")),
        ("lood.amplitude=1", ("lood",)),
    ],
)
def test_a_problem_with_an_overridden_value_is_placed_at_the_override(override, path):
    _, problems = parse_toml(TEXT, "s.toml", [override])
    problems.add(path, "wrong", 1, "right")
    with pytest.raises(InvalidInput, match=f"^--set {override.split('=')[0]}: "):
        problems.raise_if_any()


def test_what_a_refusal_recommends_is_accepted():
    with pytest.raises(InvalidInput) as caught:
        load("line-y24", ["run.t_end"])
    recommended = re.search(r"e\.g\. (\S+=\".*\")", caught.value.problems[0].right)
    assert load("line-y24", [recommended[1]]).t_end == 2.0
