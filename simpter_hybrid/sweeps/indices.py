"""Sobol indices of every measure of a sweep."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..files.json_text import json_text
from .sobol import SobolIndices, sobol_indices
from .table import Table


def indices(table: Table, measure: str, seed: int = 0) -> SobolIndices:
    """Sobol indices of a measure.

    Parameters
    ----------
    table : Table
    measure : str
        One of ``table.measures``.
    seed : int
        Of the bootstrap intervals.

    Raises
    ------
    ValueError
        If the sweep's design was not made for them (method ``saltelli``), or too many cases failed.
    KeyError
        If there is no such measure.
    """
    if not table.design.saltelli:
        raise ValueError("the design is none for Sobol indices; sweep with method='saltelli'")
    return sobol_indices(table.design.paths, table.column(measure), seed=seed)


def varying(table: Table) -> list[str]:
    """Measures that are there for all good cases and not the same for all.

    Parameters
    ----------
    table : Table
    """
    found = []
    good = [k for k, record in enumerate(table.records) if record.good]
    for name in table.measures:
        values = table.column(name)[good]
        if len(values) > 1 and np.isfinite(values).all() and np.ptp(values) > 0.0:
            found.append(name)
    return found


def indices_json(table: Table) -> str:
    """The indices of every measure that varies, as JSON.

    Parameters
    ----------
    table : Table
        Of a design for Sobol indices, else every measure has a ``problem`` only.
    """
    found: dict[str, dict[str, Any]] = {}
    for name in varying(table):
        try:
            its = indices(table, name)
        except ValueError as error:
            found[name] = {"problem": str(error)}
            continue
        found[name] = {
            "variance": its.variance, "rows": its.used, "rows_left_out": its.dropped,
            "confidence": its.confidence,
            "parameters": {
                path: {
                    "first": its.first[k], "first_interval": list(its.first_interval[k]),
                    "total": its.total[k], "total_interval": list(its.total_interval[k]),
                }
                for k, path in enumerate(its.names)
            },
        }  # fmt: skip
    return json_text({"format": "simpter_hybrid sobol indices 1", "measures": found})
