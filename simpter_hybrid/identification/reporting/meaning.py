"""What a name in a verdict means, in a few words; and what is said of its form."""

from __future__ import annotations

import sys

from ...effect import Effect
from ..fitting.predictor import Candidate
from ..rigs.effect_candidate import EffectCandidate

#: Errors of sensors that no record of angles and forces at a tip tells from the machine's geometry.
TURNED_PARTS = ("angle-offset",)
#: Gains of a rotor's sensors that a bearing beside the clutch looks like, if it rubs in proportion
#: to the clutch's torque; with the sign they have: the motor gives what the other sensor misses.
LIKE_A_BEARING = {"sensor gain": -1, "motor sensor gain": 1}
#: Of a form that leaves more than noise, and of one that may; its intervals say so as well.
INCOMPLETE = " is incomplete"
OR_NOISE = f"{INCOMPLETE}, or what is left is noise"


def meaning(one: Candidate) -> str:
    """What the effects of a name are, in brackets: the first lines of their modules; "" if none."""
    if one.name in TURNED_PARTS:
        return (
            " (an error of the sensor; a part that stands turned by as much, a handle beside its "
            "link's line say, looks the same)"
        )
    if one.name in LIKE_A_BEARING:
        return " (an error of the sensor)"
    if one.acts_on == "sensor":
        return " (an error of the sensor, not of the machine)"
    parts = one.effects() if isinstance(one, EffectCandidate) else ()
    words = "; ".join(filter(None, dict.fromkeys(map(first_line, parts))))
    return f" ({words})" if words else ""


def first_line(effect: Effect) -> str:
    """What an effect is: the first line of its module, as a part of a sentence."""
    line = (sys.modules[type(effect).__module__].__doc__ or "").strip().split("\n")[0].rstrip(".:")
    return line[:1].lower() + line[1:]
