"""What a name does not carry: a size that data do not tell, runs held out that it leaves far."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..result import Diagnosis

#: Runs of one kind are named if they err so many times as much as those that select ...
FAR = 3.0
#: ... and so many times the floor.
ABOVE = 2.0
#: Repeated runs of one kind are named if they differ so many times as much as those of most kinds
#: (of own recordings without such events 1.2 at most), of so many kinds at least.
UNSTEADY, KINDS = 1.5, 3


def unsized_sentence(found: Diagnosis, parameters: Sequence[Mapping[str, Any]]) -> str:
    """Which effects that were named have sizes that may all be zero; "" where none is such.

    Parameters
    ----------
    found : Diagnosis
    parameters : sequence of mapping
        Rows as of `parameter_rows`.
    """
    told = {p["name"]: p for p in parameters}
    unsized = [
        e.listed_as for e in found.search.corrected.effects
        if e.sizes and all(n in told and not _told(told[n]) for n in e.sizes)
    ]  # fmt: skip
    if not unsized:
        return ""
    return (
        f"These data do not tell how large {' and '.join(unsized)} would be: every 95 % interval "
        "holds zero. Take what is named for a hint."
    )


def _told(row: Mapping[str, Any]) -> bool:
    return row["half_width"] is not None and abs(row["value"]) > row["half_width"]


def uneven_sentence(found: Diagnosis) -> str:
    """Which runs held out the corrected model leaves far worse than those that select; else ""."""
    if found.search.verdict.kind == "nothing missing":  # whose sentence says so itself
        return ""
    select = found.search.corrected.select_error / found.search.floor
    after, floor = found.error_by_experiment["after"], found.floors.report
    far = {n: e / floor for n, e in after.items() if e / floor > max(ABOVE, FAR * select)}
    if not far:
        return ""
    runs = ", ".join(f"{name} {times:.3g}" for name, times in far.items())
    return (
        f"Of the runs held out some are far worse than those that select ({runs} times the floor, "
        f"against {select:.3g}): what they do differently nothing here explains; let some of their "
        "kind fit and select as well."
    )


def unsteady_sentence(floors: Mapping[str, float]) -> str:
    """Which repeated runs differ far more than most: what comes now and then is in the floor.

    Parameters
    ----------
    floors : mapping of str to float
        Experiment -> what its repeated runs differ by, in any unit.
    """
    if len(floors) < KINDS:
        return ""
    usual = float(np.median(list(floors.values())))
    named = {n: f / usual for n, f in floors.items() if f > UNSTEADY * usual}
    if not named:
        return ""
    runs = ", ".join(f"{name} {times:.1f}" for name, times in named.items())
    return (
        f"Repeated runs of some kinds differ far more than those of most ({runs} times as much): "
        "what comes in one and not in the other is in the floor, and nothing here looks for it."
    )
