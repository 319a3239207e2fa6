"""One reading of a file reports everything that is wrong with it, by line."""

import pytest

from simpter_hybrid.files.tomlfile import parse_toml
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.reading.reader import TableReader


def messages(text, read, overrides=()):
    """What reading a text with ``read(table)`` complains of."""
    data, problems = parse_toml(text, "s.toml", overrides)
    root = TableReader(data, problems)
    read(root)
    root.done()
    try:
        problems.raise_if_any()
    except InvalidInput as error:
        return str(error).split("\n")
    return []


def test_many_problems_in_the_order_of_their_lines():
    text = """
mode = "smoth"
[load]
angel = "5 deg"
amplitude = "5 lb"
[[effects]]
name = "a"
[[effects]]
rise = 3
"""

    def read(root):
        for effect in root.tables("effects"):
            effect.text("name")
            effect.quantity("time", "rise", default="20 ms")
        load = root.table("load")
        load.quantity("force", "amplitude")
        load.quantity("angle", "angle", default="0 deg")
        root.choice("mode", ["smooth", "step"])
        root.table("controller").quantity("frequency", "rate")

    assert messages(text, read, ["load.amplitude=7"]) == [
        "s.toml:1: controller: missing, got nothing; expected a table, [controller]",
        's.toml:2: mode: not a valid name, got "smoth"; '
        'expected one of "smooth", "step" (did you mean "smooth"?)',
        's.toml:4: load.angel: unknown key, got "5 deg"; '
        "expected one of amplitude, angle (did you mean angle?)",
        "s.toml:8: effects.1.name: missing, got nothing; expected a text in quotes",
        "s.toml:9: effects.1.rise: a number without a unit, got 3; "
        'expected a time with its unit, e.g. "20 ms"',
        "--set load.amplitude: a number without a unit, got 7; "
        'expected a force with its unit, e.g. "7 lbf"',
    ]


@pytest.mark.parametrize(
    ("value", "read", "what", "right"),
    [
        ('"5 lb"', lambda t: t.quantity("force", "x"), "lbf or lbm?", "lbf for a force"),
        ("nan", lambda t: t.number("x"), "not a finite number", "a number"),
        ("-inf", lambda t: t.number("x"), "not a finite number", "a number"),
        ("true", lambda t: t.number("x"), "not a quantity, got true", "a number"),
        ("2024-01-01", lambda t: t.number("x"), "not a quantity, got 2024-01-01", "a number"),
        ("2.0", lambda t: t.number("x", min=0, max=1.5), "out of range", "at least 0 and at most"),
        ("0.0", lambda t: t.number("x", above=0), "out of range", "above 0"),
        ("1", lambda t: t.number("x", below=1), "out of range", "below 1"),
        ('"0 s"', lambda t: t.quantity("time", "x", above="0 ms"), "out of range", "above 0 ms"),
        ('"9 m"', lambda t: t.quantity("length", "x", max=1), "out of range", "at most 1 m"),
        ("2.5", lambda t: t.integer("x"), "not a whole number", "a whole number"),
        ("true", lambda t: t.integer("x"), "not a whole number", "a whole number"),
        ("0", lambda t: t.integer("x", min=1), "out of range", "at least 1"),
        ("1", lambda t: t.boolean("x"), "not a boolean, got 1", "true or false"),
        ("5", lambda t: t.text("x"), "not a text, got 5", "a text"),
        ('" "', lambda t: t.text("x"), "not a text", "a text"),
        ("5", lambda t: t.choice("x", ["a"]), "not a valid name, got 5", '"a"'),
        ("[1]", lambda t: t.choice("x", ["a", "b"]), "not a valid name", 'one of "a", "b"'),
        ("5", lambda t: t.table("x"), "not a table, got 5", "a table"),
        ("[]", lambda t: t.table("x"), "not a table, got an array of 0", "a table"),
        ("{}", lambda t: t.tables("x"), "not an array, got a table", "an array, each a table"),
        ("5", lambda t: t.vector("length", "x"), "not an array, got 5", "each a length"),
        ("[1]", lambda t: t.vector("dimensionless", "x", 2), "wrong number", "an array of 2"),
        ('""', lambda t: t.texts("x"), "not an array", "each a text"),
        ("{y = 1}", lambda t: t.table("x"), "unknown key, got 1", "no key at all"),
        ("5", lambda t: t.problem("x", "too far from y", "x near y"), "too far from y", "x near y"),
    ],
)
def test_a_wrong_value(value, read, what, right):
    (message, *others) = messages(f"\nx = {value}", lambda t: (read(t), t.raw("x")))
    assert not others
    place, _, rest = message.partition(": ")
    assert place == "s.toml:2"
    found, _, expected = rest.partition("; expected ")
    assert what in found
    assert right in expected


def test_each_wrong_element_of_an_array_is_named():
    text = 'x = ["1 in",\n 2,\n "3 kg"]\ny = ["", "b"]\nz = [{}, 5]'

    def read(table):
        table.vector("length", "x", 3)
        table.texts("y")
        table.tables("z")

    places = [": ".join(m.split(": ")[:2]) for m in messages(text, read)]
    assert places == ["s.toml:2: x.1", "s.toml:3: x.2", "s.toml:4: y.0", "s.toml:5: z.1"]


def test_right_values_are_read_without_complaint():
    text = """
length = "24 in"
gain = 0.5
count = 3
on = true
name = "a"
pair = ["1 in", "2 in"]
[inner]
key = 1
[[many]]
key = 2
"""
    values = []

    def read(table):
        values.extend(
            [
                table.quantity("length", "length", min="1 in", max=1),
                table.number("gain", above=0, below=1),
                table.integer("count", min=3, max=3),
                table.boolean("on"),
                table.choice("name", ["a", "b"]),
                table.vector("length", "pair", 2),
                table.table("inner").raw("key"),
                [each.integer("key") for each in table.tables("many")],
                table.quantity("time", "delay", default="20 ms"),
                table.table("absent", default={}).text("key", default="z"),
                table.tables("none", default=()),
            ]
        )

    assert messages(text, read) == []
    assert values == [0.6096, 0.5, 3, True, "a", [0.0254, 0.0508], 1, [2], 0.02, "z", []]


def test_values_that_come_from_no_file_name_their_source():
    from simpter_hybrid.problems import Problems

    problems = Problems("Scenario(...)")
    TableReader({"x": 5}, problems).quantity("length", "x")
    with pytest.raises(InvalidInput, match=r"^Scenario\(\.\.\.\): x: a number without a unit"):
        problems.raise_if_any()
