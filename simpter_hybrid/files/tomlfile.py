"""Read a TOML file with the lines of its keys, apply overrides to it, write one."""

import math
import os
import re
import sys
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from simpter_hybrid.files.special import not_a_file
from simpter_hybrid.files.tomlkeys import key_lines, split_key
from simpter_hybrid.problems import (
    MISSING,
    InvalidInput,
    KeyPath,
    Problem,
    Problems,
    path_text,
    show,
)

LARGEST_FILE = 1_000_000  # bytes
#: Standard input, as the name of a file.
STDIN = "-"
# tomllib's time is quadratic in the parts of one key: 8000 take 1.3 s.
_ENDLESS_KEY = re.compile(r"""(?:\.[ \t]*(?:[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*){100}""")


class TomlFile(NamedTuple):
    """What a file says, overrides applied, and the collector that knows its lines."""

    data: dict[str, Any]
    problems: Problems


def read_toml(file: str | os.PathLike, overrides: Sequence[str] = ()) -> TomlFile:
    """Read a TOML file.

    Parameters
    ----------
    file : path
        ``-`` is standard input.
    overrides : sequence of str
        ``path=value``, e.g. ``"loads.0.along=5 lbf"``, ``"effects.0.rise=0.2"``. The value is
        TOML, or else text: ``5 lbf`` needs no quotes. Tables that are missing are made.

    Returns
    -------
    TomlFile
        Overrides that cannot be applied are among its problems already.

    Raises
    ------
    InvalidInput
        The file cannot be read, is too large, is not UTF-8, or is not TOML.
    """
    return parse_toml(*read_text(file), overrides)


def read_text(file: str | os.PathLike) -> tuple[str, str]:
    """Text of a TOML file, and what messages call it; of standard input there is one reading.

    Parameters
    ----------
    file : path
        As for `read_toml`.

    Raises
    ------
    InvalidInput
        The file cannot be read, is too large, or is not UTF-8.
    """
    source = os.fspath(file)
    return _text_of(source), "stdin" if source == STDIN else source


def parse_toml(text: str, source: str, overrides: Sequence[str] = ()) -> TomlFile:
    """Parse TOML that is given as text; `source` is what messages call the text.

    Overrides are those of `read_toml`.

    Parameters
    ----------
    text, source : str
    overrides : sequence of str

    Raises
    ------
    InvalidInput
        If the text is not TOML, or has a key of very many parts.
    """
    from tomllib import loads

    written, text = text, text.replace("\r\n", "\n")  # as `loads` itself does, once
    if match := _ENDLESS_KEY.search(text):
        where = f"{source}:{text.count(chr(10), 0, match.start()) + 1}"
        raise _refusal(where, "a key of very many parts", match[0], "at most 100 parts")
    try:
        data = loads(written)
        file = TomlFile(data, Problems(source, {(): 1, **key_lines(text)}))
    except (ValueError, RecursionError) as error:  # TOMLDecodeError is a ValueError
        raise _syntax_problem(text, source, error) from None
    for override in overrides:
        _override(file, override)
    return file


def dump_toml(mapping: Mapping[str, Any]) -> str:
    """TOML text of a mapping: its order, floats with all their digits.

    Parameters
    ----------
    mapping : mapping
        Texts, numbers, bools, lists, tuples and mappings of them.

    Raises
    ------
    ValueError
        For a float that is not finite.
    TypeError
        For what TOML cannot hold.
    """
    from tomli_w import dumps

    def check(value: Any, path: KeyPath) -> None:
        if isinstance(value, float) and not math.isfinite(value):
            raise ValueError(f"{path_text(path)}: {value} cannot be written to a TOML file")
        if isinstance(value, Mapping | list | tuple):
            for key, item in value.items() if isinstance(value, Mapping) else enumerate(value):
                check(item, (*path, key))

    check(mapping, ())
    return dumps(mapping)


def _refusal(where: str, what: str, value: Any, right: str) -> InvalidInput:
    return InvalidInput([Problem(where, "", what, show(value), right)])


def _text_of(source: str) -> str:
    right = "a readable TOML file"
    if source == STDIN:
        return _decoded(sys.stdin.buffer.read(LARGEST_FILE + 1), "stdin")
    try:
        special = not_a_file(source)
        if not special:
            with open(source, "rb") as stream:
                raw = stream.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:  # ValueError: a null character in the name
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise _refusal(
            show(source).strip('"'), f"cannot be read ({reason})", MISSING, right
        ) from None
    if special:
        raise _refusal(source, special, source, right)
    return _decoded(raw, source)


def _decoded(raw: bytes, source: str) -> str:
    """The text of a file, of UTF-8 and not too long."""
    if len(raw) > LARGEST_FILE:
        right = f"at most {LARGEST_FILE} (long series belong in a CSV file)"
        raise _refusal(source, "too many bytes in the file", len(raw), right)
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        byte = f"byte 0x{raw[error.start]:02x}"
        raise _refusal(f"{source}:{line}", "not UTF-8 text", byte, "UTF-8 text") from None


def _syntax_problem(text: str, source: str, error: Exception) -> InvalidInput:
    """What tomllib says, with its place where the user looks for it."""
    reason, _, position = str(error).partition(" (at ")
    if match := re.match(r"line (\d+)", position):
        line = int(match[1])
    else:
        line = text.rstrip("\n").count("\n") + 1 if position else 1
    if isinstance(error, RecursionError):
        reason = "nested too deeply"
    elif not position:  # the one other error: an integer that Python refuses to read
        reason = "an integer of too many digits"
    found = text.split("\n")[line - 1].strip()
    right = 'TOML; a quantity stands in quotes, e.g. length = "24 in"'
    reason = reason[:1].lower() + reason[1:]
    return _refusal(f"{source}:{line}", f"not valid TOML ({reason})", found, right)


def _override(file: TomlFile, text: str) -> None:
    """Apply one ``path=value``, or record why it cannot be."""
    name, equals, value_text = (part.strip() for part in text.partition("="))
    where = f"--set {name}"
    try:
        keys = split_key(name)
        value = _override_value(value_text)
    except ValueError as error:
        keys, equals, what = (), "", f"not an override ({error})"
    else:
        what = "not an override (no =)"
    if not equals:
        right = 'path=value, e.g. run.t_end="2 s"'
        return file.problems.add((), what, text, right, where)

    node: Any = file.data
    path: KeyPath = ()
    places = file.problems.places
    for depth, name in enumerate(keys):
        key: str | int = name
        if isinstance(node, list):
            if not re.fullmatch("[0-9]{1,9}", name) or int(name) >= len(node):
                right = f"an index below {len(node)}"
                return file.problems.add((*path, name), "no such element", name, right, where)
            key = int(name)
        elif not isinstance(node, dict):
            right = f"a table, for {key} to be set in it"
            return file.problems.add(path, "not a table", node, right, where)
        path = (*path, key)
        if depth == len(keys) - 1:
            node[key] = value
        elif isinstance(node, dict) and key not in node:
            node[key] = {}
            places[path] = where
        node = node[key]
    for old in [place for place in places if place[: len(path)] == path]:
        del places[old]
    places[path] = where


def _override_value(text: str) -> Any:
    from tomllib import loads

    try:
        table = loads(f"value = {text}")
        if table.keys() == {"value"}:
            return table["value"]
    except (ValueError, RecursionError):
        if text.startswith(("[", "{", '"', "'")):
            raise ValueError("the value is not valid TOML") from None
    return text
