"""What an imbalance that was found makes of the declared weight of an axis."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...devices.one_axis import OneAxis
from ...effects.imbalance import Imbalance
from ..result import Diagnosis

#: Another part of the declared weight than this is worth a question, ...
PART = 0.1
#: ... if what pulls another way is less than this part of that.
BESIDE = 0.25
#: A weight that is less than this part of an imbalance is as good as none.
NEXT_TO_NONE = 0.05


def other_weight_sentence(found: Diagnosis) -> str:
    """Sentence that a declared weight may be wrong, or that none is declared; else "".

    A moment that goes with sine and cosine of the angle is a weight's, whatever it is called.
    """
    model: Any = found.search.corrected
    made = [effect for e in model.effects for effect in e.made(model.values)]
    mine = [effect for effect in made if isinstance(effect, Imbalance)]
    if not mine:
        return ""
    device = model.predictor.declared.device
    groups = model.predictor.declared.notes.get("tolerances", ())
    known = {name for t in groups for name in t["parameters"]}
    if not isinstance(device, OneAxis) or "device.weight" in known:
        return ""
    more = np.array([sum(e.sine for e in mine), sum(e.cosine for e in mine)])
    weight = device.weight * np.array([-np.cos(device.hanging), np.sin(device.hanging)])
    square = float(weight @ weight)
    if np.sqrt(square) < NEXT_TO_NONE * np.linalg.norm(more):
        pulls = np.degrees(np.arctan2(more[1], -more[0]))
        return (
            "A weight does what imbalance does, and hardly any is declared (the device's "
            f"`weight`): {np.hypot(*more):.3g} N*m here, which hangs at {pulls:.3g} deg."
        )
    part = float(more @ weight) / square
    beside = float(np.linalg.norm(more - part * weight)) / np.sqrt(square)
    if abs(part) <= PART or beside > BESIDE * abs(part):
        return ""
    if 1.0 + part < 0.0:
        return (
            "With imbalance the weight of the axis pulls the other way: is it declared where it "
            "hangs (`hanging` of the device)?"
        )
    return (
        f"With imbalance the axis has {1.0 + part:.3g} times its declared weight "
        f"({device.weight:.3g} N*m): is that right? Give `device.weight` a tolerance, if it is not "
        "known so well."
    )
