"""Errors run by run of the runs that fit and select: which one a refit does not serve."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..fitting.residual import errors_by_run
from ..result import Diagnosis
from .tables import number, table

#: Most runs that a page lists.
LISTED = 30


def errors_of_runs(found: Diagnosis) -> dict[str, list[dict[str, Any]]]:
    """``fit`` and ``select`` -> run, its errors ``refitted`` and ``after``, times the floor."""
    models = {"refitted": found.search.refitted, "after": found.search.corrected}
    parts = {"fit": found.split.fit, "select": found.split.select}
    floors = {"fit": found.floors.fit, "select": found.floors.select}
    rows: dict[str, list[dict[str, Any]]] = {}
    for part, replays in parts.items():
        errors = {
            stage: errors_by_run(model.predictor.predict(model.values, replays), replays)
            for stage, model in models.items()
        }
        rows[part] = [
            {"run": r.name, **{stage: float(e[i]) / floors[part] for stage, e in errors.items()}}
            for i, r in enumerate(replays)
        ]
    return rows


def run_table(told: Mapping[str, list[dict[str, Any]]]) -> str:
    """Table of them, those with the largest errors first where there are many."""
    rows = [(part, one) for part, runs in told.items() for one in runs]
    shown = rows if len(rows) <= LISTED else sorted(rows, key=lambda r: -r[1]["after"])[:LISTED]
    most = f"<p>The {len(shown)} with the largest errors, of {len(rows)}.</p>"
    head = ("run, times the floor of noise", "used to", "refitted", "after")
    cells = (
        (one["run"], part, number(one["refitted"]), number(one["after"])) for part, one in shown
    )
    return table(head, cells) + (most if len(shown) < len(rows) else "")
