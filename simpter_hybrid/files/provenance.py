"""Which of a scenario's values are inferred rather than given by its source, and their labels."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from ..problems import Problems

LABEL = "# inferred"


def leaves(value: Any, path: tuple[str, ...] = ()) -> Iterable[tuple[str, ...]]:
    """Paths of the values of a document; a table of numbers is one value.

    Parameters
    ----------
    value : object
        A document, or a part of it.
    path : tuple of str
        Where that stands.
    """
    if isinstance(value, Mapping):
        for key, item in value.items():
            yield from leaves(item, (*path, key))
    elif isinstance(value, list) and value and all(isinstance(v, Mapping) for v in value):
        for k, item in enumerate(value):
            yield from leaves(item, (*path, str(k)))
    else:
        yield path


def _covers(above: tuple[str, ...], path: tuple[str, ...]) -> bool:
    return path[: len(above)] == above


def inferred_values(
    named: list[str], document: Mapping[str, Any], problems: Problems
) -> tuple[str, ...]:
    """The inferred values by their paths in a scenario written out in full.

    Parameters
    ----------
    named : list of str
        Paths of values or of whole tables, e.g. ``"device"``, ``"loads.0.lines"``.
    document : mapping
        The scenario written out in full.
    problems : Problems
        Receives paths that name nothing; values given on the command line are not inferred.
    """
    known = [p for p in leaves(document) if p[-1] != "kind"]
    given = [
        tuple(map(str, path))
        for path, place in problems.places.items()
        if str(place).startswith("--set")
    ]
    # Of another kind a table has other keys.
    replaced = [g[:-1] if g[-1] == "kind" else g for g in given]
    found: dict[str, None] = {}
    for k, name in enumerate(named):
        parts = tuple(name.split("."))
        covered = [p for p in known if _covers(parts, p)]
        if not covered and not any(_covers(g, parts) for g in replaced):
            right = "the path of a value or table of the scenario written out, e.g. loads.0.lines"
            problems.add(("inferred", k), "names nothing", name, right)
        for path in covered:
            if not any(_covers(g, path) or _covers(path, g) for g in given):
                found[".".join(path)] = None
    return tuple(found)


def labelled(text: str, inferred: Iterable[str]) -> str:
    """A document's text with a comment at each inferred value.

    Parameters
    ----------
    text : str
        As ``dump_toml`` writes it.
    inferred : iterable of str
        Paths, see `inferred_values`.
    """
    wanted = set(inferred)
    if not wanted:
        return text
    lines: list[str] = []
    at: tuple[str, ...] = ()
    counts: dict[str, int] = {}
    inline: tuple[tuple[str, ...], int] | None = None
    for line in text.splitlines():
        if header := re.fullmatch(r"(\[\[?)([\w.]+)\]\]?", line):
            at = _header(header[2], header[1] == "[[", counts)
        elif item := re.match(r"    \{ (.*) \},$", line):
            if inline is not None:
                keys = re.findall(r"(\w+) = ", item[1])
                marked = [k for k in keys if ".".join((*inline[0], str(inline[1]), k)) in wanted]
                line += f"  {LABEL}: {', '.join(marked)}" if marked else ""
                inline = (inline[0], inline[1] + 1)
        elif key := re.match(r"(\w+) = ", line):
            path = (*at, key[1])
            inline = (path, 0) if line.endswith("= [") else None
            line += f"  {LABEL}" if ".".join(path) in wanted else ""
        lines.append(line)
    return "\n".join(lines) + "\n"


def _header(name: str, of_array: bool, counts: dict[str, int]) -> tuple[str, ...]:
    """Path of the table that a header opens, with the indices of the arrays it lies in."""
    if of_array:
        counts[name] = counts.get(name, -1) + 1
        for inner in [other for other in counts if other.startswith(name + ".")]:
            del counts[inner]
    path: list[str] = []
    parts = name.split(".")
    for k, part in enumerate(parts):
        path.append(part)
        if (found := counts.get(".".join(parts[: k + 1]))) is not None:
            path.append(str(found))
    return tuple(path)
