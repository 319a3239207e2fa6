"""Parts of what was named that may be none: weight off the axis beside cogging, one of two waves.

A name of several parts is found where all of them together help, though one does all of it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from ...effect import Effect
from ...effects.position_friction import PositionFriction
from ..result import Diagnosis
from ..rigs.effect_candidate import EffectCandidate
from .meaning import first_line
from .size_intervals import may_all_be_zero


def parts_sentence(found: Diagnosis, parameters: Sequence[Mapping[str, Any]]) -> str:
    """Which parts of the effects that were named may be none; "" if every part is shown.

    Parameters
    ----------
    found : Diagnosis
    parameters : sequence of mapping
        Rows as of `parameter_rows`.
    """
    told = {p["name"]: p for p in parameters}
    effects = (e for e in found.search.corrected.effects if isinstance(e, EffectCandidate))
    return " ".join(filter(None, (_of_one(e, told) for e in effects)))


def _of_one(effect: EffectCandidate, told: Mapping[str, Mapping[str, Any]]) -> str:
    parts = parts_of(effect)
    none = [part for part, sizes in parts.items() if may_all_be_zero(sizes, told)]
    if len(parts) < 2 or not none:
        return ""
    if len(none) == len(parts):
        # Where the whole effect has sizes it is said of these.
        return "" if effect.sizes else (
            f"Of {effect.name} no part is sure by itself ({_listed(parts)}): no 95 % interval "
            "of their sizes leaves zero out."
        )  # fmt: skip
    shown = [part for part in parts if part not in none]
    return (
        f"Of {effect.name} these data show {_listed(shown)}, and no more: of {_listed(none)} "
        "no 95 % interval leaves zero out, and there may be none."
    )


def parts_of(effect: EffectCandidate) -> dict[str, list[str]]:
    """Names of the sizes of each part of an effect, by what that part is in words.

    Sine and cosine of one wave are one amplitude; so is a wave of several clutches one part.
    """
    parts: dict[str, dict[str, None]] = {}
    for which, one in enumerate(effect.effects()):
        for name, field in effect.fields(which):
            if field in one.sizes:
                parts.setdefault(_part(one, field), {})[name] = None
    return {part: list(names) for part, names in parts.items()}


def _part(effect: Effect, field: str) -> str:
    """What a size of an effect is of, in words."""
    if not isinstance(effect, PositionFriction):
        return first_line(effect)
    often = f"{effect.number:g} times" if field.startswith("often") else "once"
    return f"the wave of friction {often} a turn"


def _listed(parts: Iterable[str]) -> str:
    return " and ".join(parts)
