"""Whatever stands behind a file name: a located problem, never another exception or a hang."""

import contextlib
import os

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simpter_hybrid.files.tomlfile import LARGEST_FILE, parse_toml, read_toml
from simpter_hybrid.problems import InvalidInput


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("b = 1\nlength = 24 in\n", ":2: not valid TOML .*length = 24 in.* quotes"),
        ("a =", ":1: not valid TOML"),
        ("a = 1\n[b\n\n", ":2: not valid TOML"),
        ("\n\na = 'x", ":3: not valid TOML"),
        ("a = [1,\n2\n3]", ":3: not valid TOML .unclosed array"),
        ("[t]\nx = 1\n[t]\n", ":3: not valid TOML .cannot declare"),
        ("a = " + "[" * 100_000, ":1: not valid TOML .nested too deeply"),
        ("a = " + "9" * 5000, ":1: not valid TOML .an integer of too many digits"),
        ("a = 1\r\r\n", ":1: not valid TOML"),
        ("\n" + ".".join("x" * 5000) + " = 1", ":2: a key of very many parts"),
    ],
    ids=lambda text: text[:12],
)
def test_not_toml(text, message):
    with pytest.raises(InvalidInput, match=f"^s.toml{message}") as caught:
        parse_toml(text, "s.toml")
    assert len(str(caught.value)) < 400
    assert "; expected " in str(caught.value)


def test_files_that_are_none(tmp_path):
    (tmp_path / "latin.toml").write_bytes(b"a = 1\nb = '\xff'")
    (tmp_path / "large.toml").write_bytes(b"#" * (LARGEST_FILE + 1))
    os.mkfifo(tmp_path / "pipe.toml")
    expected = {
        "": "a directory, not a file",
        "none.toml": r"cannot be read \(no such file",
        "pipe.toml": "a pipe or device",
        "latin.toml": "not UTF-8 text",
        "large.toml": "too many bytes",
        "null\0.toml": "cannot be read",
    }
    for name, message in expected.items():
        with pytest.raises(InvalidInput, match=message):
            read_toml(f"{tmp_path}/{name}")


def test_windows_line_ends_and_byte_order_mark_are_read(tmp_path):
    (tmp_path / "dos.toml").write_bytes('\ufeffa = 1\r\nb = """x\r\ny"""\r\nc = 4'.encode())
    data, problems = read_toml(tmp_path / "dos.toml")
    assert data == {"a": 1, "b": "x\ny", "c": 4}
    assert problems.places[("c",)] == data["c"]


@given(st.text(alphabet="ab.=[]{}\"'#,\n\r\\ 1-:", max_size=40), st.text(max_size=10))
def test_any_text_is_read_or_refused(text, override):
    with contextlib.suppress(InvalidInput):
        data, _ = parse_toml(text, "s.toml", [override, text])
        assert isinstance(data, dict)
