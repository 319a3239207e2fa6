"""What an effect takes away from a declared number that may be wrong itself."""

from __future__ import annotations

from typing import Any

from ...effects.asymmetry import Asymmetry
from ...laws.axis_friction import CoulombViscous
from ...reading.fields import resolved
from ...units import si_unit
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
    said = " and ".join(below)
    known = {n for t in predictor.declared.notes.get("tolerances", ()) for n in t["parameters"]}
    runner = predictor.runner
    drags = [
        name for name, place in runner.names.items()
        if name.endswith(DECLARED) and runner.default[place] > 0.0
    ]  # fmt: skip
    dry = {type(clutch.torque) for clutch in predictor.declared.clutches} <= {CoulombViscous}
    if not drags and dry:
        return (
            f"{said} below zero drives what it should brake, since no drag is declared that it "
            "could take from. Friction that falls with speed (stribeck) looks like that, and so "
            "does a drive that was logged too small or the wrong way round."
        )
    exact = [name for name in drags if name not in known]
    if not exact and drags and "eddy-drag" in below:
        return (
            f"{said} below zero is no brake: what it takes from {' and '.join(drags)} makes a drag "
            "of another law of that (one that rises faster than in proportion, say)."
        )
    if not exact:
        return ""
    return (
        f"{said} takes drag away: {' and '.join(exact)}, declared without a "
        "tolerance, may be too large. Give it one, and see whether anything is missing then."
    )


def one_way_sentence(found: Diagnosis) -> str:
    """Sentence that a difference between two directions takes one of them all its dry friction.

    A friction that is declared far too small looks so: more of it is found one way, and the other
    cannot have less than none.  Not asked of what is pressed.
    """
    model: Any = found.search.corrected
    mine = [e for e in model.effects if isinstance(getattr(e, "effect", None), Asymmetry)]
    if not mine:
        return ""
    scenario, size = model.predictor.scenario(model.values), mine[0].name
    share, level = (model.values.get(f"{size}.{part}", 0.0) for part in ("share", "level"))
    law = scenario.clutches[int(mine[0].effect.clutch)].torque
    friction = float(getattr(law, "coulomb", 0.0))
    pressed = bool(getattr(law, "normal", 0.0))
    left = (friction * (1.0 + share * way) + level * way for way in (1.0, -1.0))
    if pressed or friction <= 0.0 or min(left) > 0.0:
        return ""
    unit = si_unit(resolved("coordinate force", scenario.device, 0))
    return (
        f"With {size} one direction has no dry friction at all, as of a one-way brake. Is "
        f"friction declared far too small ({friction:.3g} {unit})? Then give it a wider tolerance."
    )
