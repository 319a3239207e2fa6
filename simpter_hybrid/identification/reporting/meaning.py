"""What a name in a verdict means, in a few words; and what is said of its form."""

from __future__ import annotations

import sys

from ..fitting.predictor import Candidate
from ..rigs.effect_candidate import EffectCandidate

#: Errors of sensors that no record of angles and forces at a tip tells from the machine's geometry.
TURNED_PARTS = ("angle-offset",)
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
    if one.acts_on == "sensor":
        return " (an error of the sensor, not of the machine)"
    parts = one.effects() if isinstance(one, EffectCandidate) else ()
    told = ((sys.modules[type(part).__module__].__doc__ or "").strip() for part in parts)
    lines = dict.fromkeys(text.split("\n")[0].rstrip(".:") for text in told if text)
    words = "; ".join(line[:1].lower() + line[1:] for line in lines)
    return f" ({words})" if words else ""
