"""The line noted for a key is the line on which it stands."""

import tomllib

from hypothesis import given
from hypothesis import strategies as st

from simpter_hybrid.files.tomlfile import dump_toml
from simpter_hybrid.files.tomlkeys import key_lines

# Each @ becomes the number of its line; the strings try to look like something else.
TEMPLATE = '''# [not.a.table]
title = @ # x = 1
"quo.ted" . 'k'  =  @
[load]  # [comment]
a = @
multi = """
[not]
x = 1 \\"""
""""
b = @
literal = \'\'\'
'' ]]
\'\'\'\'\'
c = @
array = [ # ]
  @, [@,
  @], {x = @, y.z = [ "x]", 'y}', @ ]}, # z
  "s,#", 1979-05-27 07:32:00, @, ]
[[effects]]
name = @
[effects.fit]
v = @
[[effects.sub]]
q = @
[[effects]]
name = @
[[ effects . sub ]]
q = @
[[effects.sub]]
q = @
[a.b]
x=@
[a]
y = {}
d.e = @
d.f = @'''
ROWS = [row.replace("@", str(i)) for i, row in enumerate(TEMPLATE.split("\n"), 1)]
DOCUMENT = "\n".join(ROWS)


def leaves(value, path=()):
    if isinstance(value, dict | list):
        for key, item in value.items() if isinstance(value, dict) else enumerate(value):
            yield from leaves(item, (*path, key))
    elif isinstance(value, int):
        yield path, value


def test_a_document_that_tries_to_mislead():
    lines = key_lines(DOCUMENT)
    numbers = dict(leaves(tomllib.loads(DOCUMENT)))
    assert len(numbers) == TEMPLATE.count("@")
    assert {path: lines[path] for path in numbers} == numbers


def test_tables_and_arrays_have_lines_too():
    lines = key_lines(DOCUMENT)
    tables = {
        ("load",): "[load]  # [comment]",
        ("effects",): "[[effects]]",
        ("effects", 0, "fit"): "[effects.fit]",
        ("effects", 1, "sub"): "[[ effects . sub ]]",
        ("effects", 1, "sub", 1): "[[effects.sub]]",
        ("a",): "[a]",
    }
    assert {path: ROWS[lines[path] - 1] for path in tables} == tables


KEYS = st.text(max_size=4) | st.sampled_from(["a", "a.b", "#", "]]", '"', "'", "\n", "=", "\\"])
TEXTS = st.text(max_size=12) | st.sampled_from(["a = 1\n[b]", '"""', "'''", "\\", "# ]"])
VALUES = st.recursive(
    TEXTS | st.booleans() | st.datetimes() | st.floats(allow_nan=False, allow_infinity=False),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(KEYS, inner, max_size=3),
    max_leaves=12,
)


@given(st.dictionaries(KEYS, VALUES, max_size=5))
def test_every_path_of_a_written_document_is_found(data):
    text = dump_toml(data).replace("\r\n", "\n")
    lines = key_lines(text)

    def paths(value, path=()):
        if isinstance(value, dict | list):
            for key, item in value.items() if isinstance(value, dict) else enumerate(value):
                yield (*path, key)
                yield from paths(item, (*path, key))

    assert set(lines) == set(paths(tomllib.loads(text)))


@given(st.dictionaries(KEYS, VALUES, max_size=5), st.data())
def test_a_value_stands_on_the_line_noted_for_it(data, choose):
    mark = 987654321012345
    path = choose.draw(st.sampled_from(list(tables(data))))
    table = data
    for key in path:
        table = table[key]
    table["mark"] = mark
    text = dump_toml(data).replace("\r\n", "\n")
    expected = text[: text.index(str(mark))].count("\n") + 1
    assert key_lines(text)[(*path, "mark")] == expected


def tables(value, path=()):
    if isinstance(value, dict):
        yield path
    if isinstance(value, dict | list):
        for key, item in value.items() if isinstance(value, dict) else enumerate(value):
            yield from tables(item, (*path, key))
