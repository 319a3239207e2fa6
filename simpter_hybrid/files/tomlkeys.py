"""Lines of the keys of a TOML document.

`tomllib` decides what is valid and what the values are, but keeps no positions.  Here it is only
found where the keys of a *valid* document stand, which takes far less than a parser.
"""

import re
from bisect import bisect_right

_PART = r"""(?:[A-Za-z0-9_-]+|"(?:[^"\\\n]|\\.)*"|'[^'\n]*')"""
_KEY = re.compile(rf"{_PART}(?:[ \t]*\.[ \t]*{_PART})*")
_SPACE = re.compile(r"(?:[ \t\n]|#[^\n]*)*")
_SCALAR = re.compile(
    r'"""(?:[^"\\]|\\.|"(?!""))*"{3,5}'
    r"|'''(?:[^']|'(?!''))*'{3,5}"
    r'|"(?:[^"\\\n]|\\.)*"'
    r"|'[^'\n]*'"
    r"|[^,\]}#\n]+",
    re.DOTALL,
)


def key_lines(text: str) -> dict[tuple[str | int, ...], int]:
    """Line of every key, table and array element of a TOML document.

    Parameters
    ----------
    text : str
        A document that `tomllib.loads` accepts, with ``\\n`` line ends.

    Returns
    -------
    dict
        Path -> line, counted from 1: ``{("load",): 3, ("load", "angle"): 4, ("effects", 0): 7}``.
    """
    return _Scan(text).lines


def split_key(key: str) -> tuple[str, ...]:
    """Parts of a dotted key: ``'load."a.b"'`` -> ``("load", "a.b")``.

    Parameters
    ----------
    key : str
        Parts may be quoted as in TOML.

    Raises
    ------
    ValueError
        If ``key`` is not a TOML key.
    """
    from tomllib import loads

    if not _KEY.fullmatch(key):
        raise ValueError(f"{key!r} is not a TOML key")
    if '"' not in key and "'" not in key:
        return tuple(part.strip() for part in key.split("."))
    table, parts = loads(f"{key} = 0"), []
    while isinstance(table, dict):
        (part,) = table
        parts.append(part)
        table = table[part]
    return tuple(parts)


def _end(pattern: re.Pattern[str], text: str, position: int) -> int:
    match = pattern.match(text, position)
    assert match, "tomllib has accepted the text"
    return match.end()


class _Scan:
    def __init__(self, text: str) -> None:
        self.text = text
        self.line_ends = [match.start() for match in re.finditer("\n", text)]
        self.lines: dict[tuple[str | int, ...], int] = {}
        last: dict[tuple[str | int, ...], int] = {}  # array of tables -> index of its last table
        table: tuple[str | int, ...] = ()
        position = self.skip(0)
        while position < len(text):
            if text.startswith("[[", position):
                parts, line, position = self.key(position + 2)
                array = (*self.resolve(parts[:-1], last, line), parts[-1])
                last[array] = last.get(array, -1) + 1
                table = (*array, last[array])
                self.lines.setdefault(array, line)
                self.lines[table] = line
                position = text.index("]]", position) + 2
            elif text[position] == "[":
                parts, line, position = self.key(position + 1)
                table = self.resolve(parts, last, line)
                self.lines[table] = line  # a table may be implied by a subtable further up
                position = text.index("]", position) + 1
            else:
                position = self.pair(position, table)
            position = self.skip(position)

    def skip(self, position: int) -> int:
        """Past blanks, line ends and comments."""
        return _end(_SPACE, self.text, position)

    def key(self, position: int) -> tuple[tuple[str, ...], int, int]:
        """Parts of the key at or after the position, its line, the position after it."""
        position = self.skip(position)
        end = _end(_KEY, self.text, position)
        line = bisect_right(self.line_ends, position - 1) + 1
        return split_key(self.text[position:end]), line, end

    def resolve(self, parts: tuple[str, ...], last: dict, line: int) -> tuple[str | int, ...]:
        """Path of a header: an array of tables on the way means its last table."""
        path: tuple[str | int, ...] = ()
        for part in parts:
            path = (*path, part)
            self.lines.setdefault(path, line)
            if path in last:
                path = (*path, last[path])
        return path

    def pair(self, position: int, table: tuple[str | int, ...]) -> int:
        """Note ``key = value``; the position after it."""
        parts, line, position = self.key(position)
        for part in parts:
            table = (*table, part)
            self.lines.setdefault(table, line)
        return self.value(self.skip(self.text.index("=", position) + 1), table)

    def value(self, position: int, path: tuple[str | int, ...]) -> int:
        """Note what stands inside a value; the position after it."""
        opening = self.text[position]
        if opening not in "[{":
            return _end(_SCALAR, self.text, position)
        position, index = self.skip(position + 1), 0
        while self.text[position] not in "]}":
            if opening == "{":
                position = self.pair(position, path)
            else:
                self.lines[(*path, index)] = bisect_right(self.line_ends, position - 1) + 1
                position, index = self.value(position, (*path, index)), index + 1
            position = self.skip(position)
            if self.text[position] == ",":
                position = self.skip(position + 1)
        return position + 1
