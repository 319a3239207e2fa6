"""A part's fields, read from a table by their metadata (``parameter``, ``rows``, ``index``)."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from ..device import Device
from ..known_units import BY_COORDINATE
from ..part import Part
from ..problems import KeyPath, show
from ..units import QuantityError, expected_quantity, parse_quantity
from .kinds import UnknownKindError, find, shipped
from .reader import REQUIRED, TableReader
from .series import Column, SeriesError, read_columns


class Context(NamedTuple):
    """What reading a part may need: the folder of its file, the device, defaults by field name."""

    folder: Path
    device: Device | None = None
    defaults: Mapping[str, Any] = {}


def coordinate_kind(device: Device | None, number: int) -> str:
    """``angle`` or ``length``; for a number below 0 what all coordinates have in common."""
    kinds = device.coordinate_dimensions if device is not None else ()
    if number < 0 and len(set(kinds)) == 1:
        return kinds[0]
    return kinds[number] if 0 <= number < len(kinds) else "angle"


def resolved(dimension: str, device: Device | None, number: int) -> str:
    """A dimension that may depend on what a coordinate measures."""
    if dimension not in BY_COORDINATE:
        return dimension
    return BY_COORDINATE[dimension][coordinate_kind(device, number)]


def fitting(dimension: str, *values: Any) -> str:
    """What most of `values` measure, where no device says what its coordinates measure."""
    if dimension not in BY_COORDINATE:
        return dimension
    known = [BY_COORDINATE[dimension][kind] for kind in ("length", "angle")]
    return max(known, key=lambda kind: sum(_is_of(value, kind) for value in values))


def _is_of(value: Any, dimension: str) -> bool:
    try:
        parse_quantity(value, dimension)
    except QuantityError:
        return False
    return True


def read_part(table: TableReader, family: str, context: Context) -> Part | None:
    """The part that a table describes by its ``kind``; None (and problems) if there is none."""
    cls = read_kind(table, family, context.folder)
    return build(table, cls, context) if cls is not None else None


def read_kind(table: TableReader, family: str, folder: Path) -> Any:
    """What a table's ``kind`` names; None (and a problem) if it names nothing."""
    kind = table.raw("kind", None)
    right = f"one of {', '.join(shipped(family))}, or module:Class"
    try:
        if "kind" not in table:
            raise UnknownKindError("missing", right)
        if not isinstance(kind, str):
            raise UnknownKindError("not a text", right)
        return find(family, kind, folder)
    except UnknownKindError as error:
        table.problem("kind", error.what, error.right)
        _mute(table)
        return None


def build(table: TableReader, cls: type[Part], context: Context, **given: Any) -> Part | None:
    """An object of ``cls`` from a table's keys; None (and problems) if any is wrong."""
    before = len(table.problems)
    values = dict(given)
    fields = [f for f in dataclasses.fields(cls) if f.init and f.name not in given]
    indices = {f.metadata.get("index", f.name) for f in fields if _is_index(f)}
    numbers = context
    if _mixed(context.device) and (indices == {"clutch"} or (cls.of_surfaces and not indices)):
        # Its surfaces may rub along lengths or over angles: no device says which.
        numbers = context._replace(device=None)
    # Indices first: what other fields measure may depend on the coordinate.
    for f in sorted(fields, key=lambda f: not _is_index(f)):
        values[f.name] = _read_field(table, f, context if _is_index(f) else numbers, values)
    if len(table.problems) > before:
        return None
    try:
        return cls(**values)
    except (ValueError, TypeError) as error:
        key, colon, reason = str(error).partition(": ")
        if colon and key in values:
            table.problem(key, reason, f"values that {cls.__name__} accepts")
        else:
            what = f"{cls.__name__} refuses its values ({error})"
            table.problems.add(table.path, what, table.data, "values it accepts")
        return None


def _mixed(device: Device | None) -> bool:
    """Whether a device has coordinates that are angles and others that are lengths."""
    return device is not None and len(set(device.coordinate_dimensions)) > 1


def _is_index(f: dataclasses.Field) -> bool:
    return "index" in f.metadata or (f.name in ("clutch", "coordinate") and f.type in ("int", int))


def _read_field(
    table: TableReader, f: dataclasses.Field, context: Context, known: Mapping[str, Any]
) -> Any:
    default = context.defaults.get(f.name, f.default)
    if default is dataclasses.MISSING:
        made = f.default_factory
        default = made() if callable(made) else REQUIRED
    if _is_index(f):
        return _read_index(table, f, default, context.device)
    number = int(next((v for k, v in known.items() if k in ("coordinate", "index")), 0))
    if "columns" in f.metadata:
        columns = tuple((c, resolved(d, context.device, number)) for c, d in f.metadata["columns"])
        given = table.data.get(f.name)
        if context.device is None and isinstance(given, list) and given:
            columns = tuple(
                (
                    c,
                    fitting(
                        d, *(row[k] for row in given if isinstance(row, list) and k < len(row))
                    ),
                )
                for k, (c, d) in enumerate(f.metadata["columns"])
            )
        return read_rows(table, f.name, columns, default, context.folder)
    if f.type in ("float", float):
        given = f.metadata.get("dimension", "dimensionless")
        dimension = resolved(given, context.device, number)
        if context.device is None and f.name in table:
            dimension = fitting(given, table.data[f.name])
        limits = {"min": f.metadata.get("low"), "max": f.metadata.get("high")}
        return table.quantity(dimension, f.name, default, **limits, above=f.metadata.get("above"))
    if f.type in ("int", int):
        return table.integer(f.name, default)
    if f.type in ("bool", bool):
        return table.boolean(f.name, default)
    if f.type in ("str", str):
        return table.text(f.name, default)
    if f.name in table:
        table.problem(f.name, f"a {f.type} cannot be given in a file", "no such key")
    table.raw(f.name, default)
    return default


def _read_index(
    table: TableReader, f: dataclasses.Field, default: Any, device: Device | None
) -> float | int:
    """Number, from 0, of a clutch (written from 1) or a coordinate (written by name)."""
    number: float | int
    kind = float if f.type in ("float", float) else int
    if f.metadata.get("index", f.name) == "clutch":
        most = device.m if device is not None else None
        if f.name not in table:
            number = table.integer(f.name, default)
        else:
            number = table.integer(f.name, min=1, max=most) - 1
    else:
        names = device.coordinates if device is not None else ()
        if f.name not in table or not names:
            number = default
            table.raw(f.name, default)
        else:
            number = names.index(table.choice(f.name, names))
    return kind(number) if number is not REQUIRED else kind(0)


def read_rows(
    table: TableReader, key: str, columns: tuple, default: Any, folder: Path
) -> tuple[tuple[float, ...], ...]:
    """Rows of SI floats: an array of arrays, or ``{file, columns, units}`` of a CSV file."""
    names = ", ".join(f"{name} ({expected_quantity(d)})" for name, d in columns)
    right = f"an array of rows [{names}], or {{file, columns, units}} of a CSV file"
    value = table.raw(key, default, right)
    path = (*table.path, key)
    if isinstance(value, Mapping):
        return _rows_of_file(table.table(key), columns, folder)
    if key not in table:
        return value
    if not isinstance(value, list | tuple):
        table.problem(key, "not a table of numbers", right)
        return ()
    found = []
    for i, row in enumerate(value):
        if not isinstance(row, list | tuple) or len(row) != len(columns):
            table.problems.add((*path, i), "not a row of the table", row, right)
            continue
        cells = zip(row, columns, strict=True)
        found.append(
            tuple(_cell(table, (*path, i, j), v, d) for j, (v, (_, d)) in enumerate(cells))
        )
    return tuple(found)


def _cell(table: TableReader, path: KeyPath, value: Any, dimension: str) -> float:
    try:
        return parse_quantity(value, dimension)
    except QuantityError as error:
        table.problems.add(path, error.what, error.value, error.right)
        return 0.0


def _rows_of_file(
    table: TableReader, columns: tuple, folder: Path
) -> tuple[tuple[float, ...], ...]:
    before = len(table.problems)
    file = table.text("file")
    names = table.texts("columns", len(columns))
    units = table.raw("units", [""] * len(columns))
    if not isinstance(units, list) or len(units) != len(columns):
        kinds = ", ".join(f"{n}: {expected_quantity(d)}" for n, d in columns)
        table.problem("units", "not one unit a column", f"an array of {len(columns)} ({kinds})")
    if len(table.problems) > before:
        return ()
    wanted = [
        Column(name, str(unit), dimension)
        for name, unit, (_, dimension) in zip(names, units, columns, strict=True)
    ]
    try:
        return read_columns(folder / file, wanted)
    except QuantityError as error:
        table.problem("units", f"{error.what} ({show(error.value)})", error.right)
    except SeriesError as error:
        for where, what, value, right in error.found:
            table.problems.add((*table.path, "file"), what, value, right, where)
    return ()


def _mute(table: TableReader) -> None:
    """Count every key as known: without its kind nothing is known about a table's keys."""
    for key in table.data:
        table.raw(key, None)
