"""What an effect takes away from a declared number that may be wrong itself."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from ...effect import Effect
from ...effects.asymmetry import Asymmetry
from ...effects.eddy_drag import EddyDrag
from ...effects.power_law_drag import PowerLawDrag
from ...effects.quadratic_drag import QuadraticDrag
from ...effects.viscous_drag import ViscousDrag
from ...laws.axis_friction import CoulombViscous
from ...reading.fields import resolved
from ...units import si_unit
from ..result import Diagnosis
from .other_weight import other_weight_sentence

#: Endings of the numbers of drag that a model may declare, as a scenario's parameters are named.
DECLARED = (
    ".viscous", "ViscousDrag.coefficient", "QuadraticDrag.coefficient", "EddyDrag.peak",
    "PowerLawDrag.level",
)  # fmt: skip
#: Drags, and what their force needs besides the speed.
DRAGS: dict[type[Effect], tuple[str, ...]] = {
    ViscousDrag: ("coefficient",), QuadraticDrag: ("coefficient",), EddyDrag: ("peak", "critical"),
    PowerLawDrag: ("level", "scale", "exponent"),
}  # fmt: skip
FOUND = ("viscous-drag", "quadratic-drag", "eddy-drag", "power-law-drag")


def declared_sentence(found: Diagnosis) -> str:
    """Sentence on declared numbers that what was found may put right; "" if there are none."""
    said = less_drag_sentence(found) or one_way_sentence(found), other_weight_sentence(found)
    return " ".join(filter(None, said))


def less_drag_sentence(found: Diagnosis) -> str:
    """Sentence that a declared drag without a tolerance may be what a negative one takes away."""
    model = found.search.corrected
    negative = [
        effect for effect in model.effects
        if effect.name in FOUND and any(model.values[name] < 0.0 for name in effect.sizes)
    ]  # fmt: skip
    below = [effect.name for effect in negative]
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
    if dry and (not drags or (part := _part_taken(found, negative)) > 1.0):
        taken = (
            f"it takes {part:.2g} times what {' and '.join(drags)} is" if drags
            else "no drag is declared that it could take from"
        )  # fmt: skip
        return (
            f"{said} below zero drives what it should brake, since {taken}. Friction that falls "
            "with speed (stribeck) looks like that, and so does a drive that was logged too small "
            "or the wrong way round, or that gives less at some speeds."
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


def _part_taken(found: Diagnosis, negative: Sequence[Any]) -> float:
    """How many times the declared drag, as refitted, is taken away, where that is least.

    Of the speeds that the fitted runs reach, from a tenth of the fastest on.
    """
    model: Any = found.search.corrected
    speeds = [run.notes["speed"] for run in found.fitted if "speed" in run.notes]
    fastest = max((float(np.max(np.abs(speed))) for speed in speeds), default=1.0)
    declared, refitted = model.predictor.declared, model.predictor.scenario(model.values)
    if declared.device.n > 1:  # whose drag is whose is not asked here
        return 0.0
    viscous = sum(getattr(clutch.torque, "viscous", 0.0) for clutch in refitted.clutches)
    known = refitted.effects[: len(declared.effects)]  # what was found stands behind them
    made = [effect for e in negative for effect in e.made(model.values)]
    parts = []
    for speed in fastest * np.linspace(0.1, 1.0, 10):
        there = viscous * speed + _drag(known, speed)
        parts.append(-_drag(made, speed) / there if there > 0.0 else np.inf)
    return min(parts)


def _drag(effects: Iterable[Any], speed: float) -> float:
    """What known drags brake with at a speed [N m or N]."""
    return -sum(
        e.force(speed, *(getattr(e, name) for name in DRAGS[type(e)]))
        for e in effects
        if type(e) in DRAGS
    )


def one_way_sentence(found: Diagnosis) -> str:
    """Sentence that a difference between two directions takes one of them all its dry friction.

    A friction that is declared far too small looks so: more of it is found one way, and the other
    cannot have less than none.  Not asked of what is pressed, nor where a declared number was found
    far off: one that is too large to be moved looks so, too.
    """
    model: Any = found.search.corrected
    mine = [e for e in model.effects if isinstance(getattr(e, "effect", None), Asymmetry)]
    if not mine or found.far_off is not None:
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
