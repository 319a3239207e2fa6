"""A drag that was found below zero: a declared one is too large, or what falls with speed is."""

from __future__ import annotations

from typing import Any

from ..result import Diagnosis

#: Endings of the numbers of drag that a model may declare, as a scenario's parameters are named.
DECLARED = (
    ".viscous", "ViscousDrag.coefficient", "QuadraticDrag.coefficient", "EddyDrag.peak",
    "PowerLawDrag.level",
)  # fmt: skip
FOUND = ("viscous-drag", "quadratic-drag", "eddy-drag", "power-law-drag")


def less_drag_sentence(found: Diagnosis) -> str:
    """Sentence that a declared drag without a tolerance may be what a negative one takes away."""
    model = found.search.corrected
    below = [
        effect.name for effect in model.effects
        if effect.name in FOUND and any(model.values[name] < 0.0 for name in effect.sizes)
    ]  # fmt: skip
    predictor: Any = found.search.refitted.predictor
    if not below or not hasattr(predictor, "runner"):
        return ""
    known = {n for t in predictor.declared.notes.get("tolerances", ()) for n in t["parameters"]}
    runner = predictor.runner
    exact = [
        name for name, place in runner.names.items()
        if name.endswith(DECLARED) and name not in known and runner.default[place] > 0.0
    ]  # fmt: skip
    if not exact:
        return ""
    return (
        f"{' and '.join(below)} takes drag away: {' and '.join(exact)}, declared without a "
        "tolerance, may be too large. Give it one, and see whether anything is missing then."
    )
