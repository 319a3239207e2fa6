"""The table of a sweep: a row a case in the order of the design, whatever came first."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..device import Device
from .axis import number_of
from .brief import unit_and_label
from .case import Record, plain
from .design import Design

FORMAT = "simpter_hybrid sweep table 1"


@dataclass(frozen=True)
class Table:
    """What a sweep found.

    Parameters
    ----------
    design : Design
    records : tuple of Record
        In the order of ``design.rows``.
    device : Device, optional
        That of the scenario varied, which tells the units of the measures.
    """

    design: Design
    records: tuple[Record, ...]
    device: Device | None = field(default=None, compare=False)

    def __len__(self) -> int:
        return len(self.records)

    @property
    def measures(self) -> list[str]:
        """Names of all measures, those of the first case first."""
        return list(dict.fromkeys(name for r in self.records for name in r.measures))

    @property
    def failed(self) -> list[int]:
        """Numbers of the cases that failed, from 0."""
        return [k for k, record in enumerate(self.records) if not record.good]

    def column(self, name: str) -> np.ndarray:
        """A measure of every case (SI), or the numbers of what was varied; (cases,), NaN if none.

        Parameters
        ----------
        name : str
            A measure or a varied path; numbers of a path are in the units they were given in.

        Raises
        ------
        KeyError
            If there is neither a measure nor a varied path of that name.
        ValueError
            If the numbers of a path were given in several units.
        """
        if name in self.design.paths:
            k = self.design.paths.index(name)
            found = [number_of(row[k]) for row in self.design.rows]
            if len(units := {f[1] for f in found if f}) > 1:
                said = ", ".join(sorted(map(str, units)))
                raise ValueError(f"{name} was given in {said}; `given` has it as it was written")
            return np.array([f[0] if f else np.nan for f in found])
        if name not in self.measures:
            raise KeyError(f"{name!r}; there are {', '.join([*self.design.paths, *self.measures])}")
        values = [r.measures.get(name) if r.good else None for r in self.records]
        return np.array([np.nan if v is None else v for v in values], dtype=float)

    def given(self, path: str) -> list[str]:
        """The values of a path, as they were written, of every case.

        Parameters
        ----------
        path : str

        Raises
        ------
        ValueError
            If it is not varied.
        """
        k = self.design.paths.index(path)
        return [row[k] for row in self.design.rows]

    def unit(self, name: str) -> str | None:
        """Unit of a column; None for a path whose values are not numbers of one unit.

        Parameters
        ----------
        name : str
            As for `column`.
        """
        if name not in self.design.paths:
            return unit_and_label(name, self.device)[0]
        found = {pair[1] if (pair := number_of(v)) else None for v in set(self.given(name))}
        return found.pop() if len(found) == 1 else None


def heading(table: Table, name: str) -> str:
    """``average_error [m]``.

    Parameters
    ----------
    table : Table
    name : str
        Of a column.
    """
    unit = table.unit(name)
    return f"{name} [{unit}]" if unit else name


def cells(table: Table) -> tuple[list[list[Any]], list[list[Any]]]:
    """Values of the varied paths and of the measures, a row a case.

    Parameters
    ----------
    table : Table

    Returns
    -------
    varied : list of list, (cases, paths)
        Numbers in the units given, or texts where a path's values are not numbers of one unit.
    measures : list of list, (cases, measures)
        Numbers [SI], None where there is none.
    """
    varied = []
    for path in table.design.paths:
        numbers = table.unit(path) is not None
        given = table.given(path)
        varied.append([number_of(v)[0] for v in given] if numbers else given)  # type: ignore[index]
    names = table.measures
    taken = [[plain(dict(r.measures).get(name)) for name in names] for r in table.records]
    return [list(row) for row in zip(*varied, strict=True)], taken


def table_csv(table: Table) -> str:
    """The table as CSV; numbers in full, SI but for the values that were given.

    Parameters
    ----------
    table : Table
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    columns = [*table.design.paths, *table.measures]
    outcome = ("case", "status", "message", "time [s]")
    writer.writerow(["number", *(heading(table, name) for name in columns), *outcome])
    varied, taken = cells(table)
    for k, record in enumerate(table.records):
        time = "" if record.time is None else repr(record.time)
        row = ["" if v is None else v for v in (*varied[k], *taken[k])]
        writer.writerow([k + 1, *row, record.case, record.status, record.message, time])
    return out.getvalue()


def table_json(table: Table) -> str:
    """The table as JSON: columns with units and labels, then the rows.

    Parameters
    ----------
    table : Table
    """
    columns: list[dict[str, Any]] = []
    for name in table.design.paths:
        columns.append({"name": name, "unit": table.unit(name), "label": "given"})
    for name in table.measures:
        unit, label = unit_and_label(name, table.device)
        columns.append({"name": name, "unit": unit, "label": label})
    varied, taken = cells(table)
    rows = [
        {"values": [*varied[k], *taken[k]], "case": r.case, "status": r.status,
         "message": r.message, "time_s": r.time}
        for k, r in enumerate(table.records)
    ]  # fmt: skip
    lines: Sequence[str] = [json.dumps(row, allow_nan=False) for row in rows]
    head = json.dumps({"format": FORMAT, "columns": columns}, indent=1)[:-2]
    return head + ',\n "rows": [\n  ' + ",\n  ".join(lines) + "\n ]\n}\n"
