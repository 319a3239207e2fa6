"""Several files of one recording as one table, whose column `FILE` tells them apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from ...problems import InvalidInput, Problem
from .columns import Columns, Places, as_text
from .files import on_its_clock, read_columns
from .map_file import FILE, RecordingMap
from .run_names import spelled


def read_files(files: Sequence[str], described: RecordingMap) -> Columns:
    """The columns that a map speaks of, of all files one below the other.

    Parameters
    ----------
    files : sequence of str
    described : RecordingMap

    Returns
    -------
    Columns
        Where the files have no column `FILE` it is their names; a column that some files lack,
        which only one of an optional channel may be, is blank there.

    Raises
    ------
    InvalidInput
        With what is wrong with each file, a file given twice, dates of which some have a zone.
    """
    problems = _twice(files)
    tables = []
    for name, file in zip(names_of(files), files, strict=True):
        try:
            table = _named(read_columns(file, described), name)
            tables.append(on_its_clock(table, described))
        except InvalidInput as wrong:
            problems.extend(wrong.problems)
    if problems:
        raise InvalidInput(problems)
    return tables[0] if len(tables) == 1 else _joined(_on_one_clock(tables, described))


def names_of(files: Sequence[str]) -> list[str]:
    """Names that differ: without folders, or, where some are alike, with them as given."""
    names = [Path(file).name for file in files]
    return names if len(set(names)) == len(names) else [Path(f).as_posix() for f in files]


def _twice(files: Sequence[str]) -> list[Problem]:
    problems, seen = [], set()
    for file in files:
        if (whole := Path(file).resolve()) in seen:
            right = "each file once: a run that counts twice is no repetition"
            problems.append(Problem(file, "", "a file given twice", file, right))
        seen.add(whole)
    return problems


def _named(table: Columns, name: str) -> Columns:
    if FILE in table.numbers or FILE in table.texts:
        return table
    return replace(table, texts={**table.texts, FILE: np.full(table.size, name)})


def _on_one_clock(tables: Sequence[Columns], described: RecordingMap) -> list[Columns]:
    """Tables whose stamps, where they are dates, all count from the first file's first date [s]."""
    name, placed = described.time.column, []
    for table in tables:
        late = 0.0
        if table.origin is not None and tables[0].origin is not None:
            if (table.origin.tzinfo is None) != (tables[0].origin.tzinfo is None):
                got, right = str(table.origin), f"a date like {tables[0].origin}, as the first has"
                where = table.places.source
                raise InvalidInput([Problem(where, "", "a date of another kind", got, right)])
            late = (table.origin - tables[0].origin).total_seconds()
        placed.append(replace(table, numbers={**table.numbers, name: table.numbers[name] + late}))
    return placed


def _joined(tables: Sequence[Columns]) -> Columns:
    first = np.cumsum([0, *(t.size for t in tables[:-1])])
    size = sum(t.size for t in tables)
    numbers: dict[str, np.ndarray] = {}
    texts: dict[str, np.ndarray] = {}
    blank: dict[str, np.ndarray] = {}
    for name in dict.fromkeys(n for t in tables for n in (*t.numbers, *t.texts)):
        apart = _written_apart(tables, name)
        if apart or any(name in t.texts for t in tables):
            texts[name] = np.concatenate(_as_texts(tables, name, apart))
            continue
        lacks = [np.full(t.size, name not in t.numbers) for t in tables]
        empty = [t.blank.get(name, none) for t, none in zip(tables, lacks, strict=True)]
        nothing = (np.full(t.size, np.nan) for t in tables)
        parts = [t.numbers.get(name, n) for t, n in zip(tables, nothing, strict=True)]
        numbers[name] = np.concatenate(parts)
        if np.any(whole := np.concatenate(empty)):
            blank[name] = whole
    lines = [t.places.lines if t.places.lines.size else np.zeros(t.size, int) for t in tables]
    files = tuple(t.places.files[0] for t in tables)
    places = Places(files, tuple(first.tolist()), np.concatenate(lines))
    left_out = tuple(place for t in tables for place in t.left_out)
    written: dict[str, dict[float, str]] = {}
    for t in tables:
        for name in t.written.keys() & numbers.keys():
            written.setdefault(name, {}).update(t.written[name])
    return Columns(numbers, texts, size, blank, places, left_out=left_out, written=written)


def _written_apart(tables: Sequence[Columns], name: str) -> bool:
    """Whether one number stands as 1.1 in one file and as 1.10 in another: see `names_of`."""
    told: dict[float, str] = {}
    known = (item for t in tables for item in t.written.get(name, {}).items())
    return any(
        np.isfinite(number) and told.setdefault(number, spelled(text)) != spelled(text)
        for number, text in known
    )


def _as_texts(tables: Sequence[Columns], name: str, apart: bool) -> list[np.ndarray]:
    """A column of each table as texts; numbers as written if `apart`, or if one stands among them.

    So it is where all are in one file.
    """
    seen = set().union(*(t.texts[name].tolist() for t in tables if name in t.texts))
    apart = apart or any(w in seen for t in tables for w in t.written.get(name, {}).values())
    found = []
    for t in tables:
        if name in t.texts:
            found.append(t.texts[name])
            continue
        written = t.written.get(name, {}) if apart else {}
        numbers = t.numbers.get(name, np.full(t.size, np.nan)).tolist()
        found.append(np.array([written.get(n) or as_text(n) for n in numbers]))
    return found
