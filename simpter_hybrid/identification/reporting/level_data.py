"""Values of a parameter that differ from run to run, as plain data."""

from __future__ import annotations

from typing import Any

from ..going_with import goes_with, split_by
from ..result import Diagnosis
from ..run_levels import as_declared, differs
from .level_sentences import counted, levels_text

#: Values of each run that take away a smaller part of what is left are no finding.
NEXT_TO_NOTHING = 0.05


def level_data(found: Diagnosis) -> dict[str, Any] | None:
    """Which parameters differ, by how much, and with what; None where that is no finding."""
    told = found.levels
    if not told or found.search.verdict.kind == "nothing missing":
        return None
    explained = all(map(differs, told))
    if not explained and (told[-1].share < NEXT_TO_NOTHING or as_declared(told[-1])):
        return None
    return {
        "sentence": "" if explained else f"{levels_text(told, found.search.floor)}.",
        "parameters": [
            {
                "parameter": levels.parameter,
                "counted": counted(levels), "at_bound": list(levels.ended),
                "runs": [
                    {"run": run, "above_median" if levels.step else "over_median": level}
                    for (run, _), level in zip(levels.levels, levels.own(), strict=True)
                ],
                "before": levels.before, "after": levels.after, "share": levels.share,
                "goes_with": goes_with(levels), "split_by": split_by(levels),
            }
            for levels in told
        ],
    }  # fmt: skip
