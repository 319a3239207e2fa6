"""Errors run by run of the runs that fit and select: which one a refit does not serve."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..fitting.residual import errors_by_run
from ..result import Diagnosis
from .tables import number, table

#: Most runs that a page lists.
LISTED = 30
STAGES = ("declared", "refitted", "after")
#: A refit spoils a run whose error it raises to so many times, if that is so far above the floor.
SPOILT, ABOVE = 1.2, 2.0
#: One run rules it that has more than this part of what squares fall by.
MOST = 0.5


def errors_of_runs(found: Diagnosis) -> dict[str, list[dict[str, Any]]]:
    """``fit`` and ``select`` -> run, its experiment, its errors by `STAGES`, times the floor."""
    refitted, after = found.search.refitted, found.search.corrected
    declared = {p.name: p.value for p in refitted.predictor.parameters}
    models = {
        "declared": (refitted.predictor, declared),
        "refitted": (refitted.predictor, refitted.values),
        "after": (after.predictor, after.values),
    }
    parts = {"fit": found.split.fit, "select": found.split.select}
    floors = {"fit": found.floors.fit, "select": found.floors.select}
    rows: dict[str, list[dict[str, Any]]] = {}
    for part, replays in parts.items():
        errors = {
            stage: errors_by_run(predictor.predict(values, replays), replays)
            for stage, (predictor, values) in models.items()
        }
        rows[part] = [
            {
                "run": r.name, "experiment": r.experiment,
                **{stage: float(e[i]) / floors[part] for stage, e in errors.items()},
            }
            for i, r in enumerate(replays)
        ]  # fmt: skip
    return rows


def spoilt_sentence(told: Mapping[str, list[dict[str, Any]]]) -> str:
    """Sentence that a refit makes most runs worse, for the sake of few; "" if it does not.

    Squares count: what is far off rules a fit, and the model's own lack is all that it follows.
    """
    runs = [r for some in told.values() for r in some if np.isfinite(r["declared"] + r["after"])]
    worse = [
        r for r in runs
        if min(r["refitted"], r["after"]) > max(SPOILT * r["declared"], ABOVE)
    ]  # fmt: skip
    fell = [max(0.0, r["declared"] ** 2 - r["refitted"] ** 2) for r in told["fit"]]
    largest = int(np.argmax(fell)) if fell else 0
    if 2 * len(worse) <= len(runs) or not fell or fell[largest] <= MOST * sum(fell):
        return ""
    most = told["fit"][largest]
    worst = max(worse, key=lambda r: r["refitted"] / r["declared"])
    return (
        f"The refit makes {len(worse)} of {len(runs)} runs worse than as declared ({worst['run']}: "
        f"{worst['declared']:.3g} to {worst['refitted']:.3g} times the floor), mostly for the sake "
        f"of {most['run']} ({most['declared']:.3g} to {most['refitted']:.3g}). If that run shows "
        "what the others do not, fit it apart: the refitted numbers are no measurement."
    )


def run_table(told: Mapping[str, list[dict[str, Any]]]) -> str:
    """Table of them, those with the largest errors first where there are many."""
    rows = [(part, one) for part, runs in told.items() for one in runs]
    shown = rows if len(rows) <= LISTED else sorted(rows, key=lambda r: -r[1]["after"])[:LISTED]
    most = f"<p>The {len(shown)} with the largest errors, of {len(rows)}.</p>"
    head = ("run, times the floor of noise", "used to", *STAGES)
    cells = ((one["run"], part, *(number(one[stage]) for stage in STAGES)) for part, one in shown)
    return table(head, cells) + (most if len(shown) < len(rows) else "")
