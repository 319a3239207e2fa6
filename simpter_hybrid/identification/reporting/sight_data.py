"""What the data can show, as plain data: visible, blind to, not separated, and the run to make."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..identifiability_report import Sight
from ..result import Diagnosis
from .sight_sentences import in_classes, otherwise

#: Ends of the names of declared numbers that are the coefficient of a viscous drag.
VISCOUS = (".torque.viscous", "ViscousDrag.coefficient")


def same_as_refitted(found: Diagnosis) -> dict[str, str]:
    """Effect -> tolerance whose one number it is itself, of one axis with one friction.

    That these runs do not tell it from that number is no blind spot: the refit has it.
    """
    predictor: Any = found.search.corrected.predictor
    if not hasattr(predictor, "declared"):  # not every predictor has a scenario
        return {}
    declared = predictor.declared
    if declared.device.n != 1 or len(declared.clutches) > 1:
        return {}
    numbers = dict(zip(declared.parameter_names(), declared.parameter_values(), strict=True))
    for tolerance in declared.notes.get("tolerances", ()):
        name, *others = tolerance["parameters"]
        if name.endswith(VISCOUS) and not others and numbers[name] > 0.0:
            return {"viscous-drag": str(tolerance["name"])}
    return {}


def sight_data(sight: Sight, found: Diagnosis, words: Mapping[str, str]) -> dict[str, Any]:
    """As the JSON has it; `words` says of each planned experiment what is laid down in it."""
    imitated = {(a, b): part for a, b, part in sight.confused}
    same = {n: as_ for n, as_ in same_as_refitted(found).items() if n in sight.blind}
    return {
        "visible": dict(sight.visible),
        "blind_to": list(sight.blind),
        "blind_to_classes": in_classes(
            [name for name in sight.blind if name not in same], found.candidates
        ),
        "same_as": same,
        "shown_by": {
            name: _ranked(runs, sight) for name, runs in sight.reveals.items() if name not in same
        },
        "cannot_separate": [
            {
                "pair": list(pair), "imitated": imitated.get(pair),
                "run_next": _ranked(runs, sight),
                "otherwise": list(otherwise(pair, sight, found.candidates)),
            }
            for pair, runs in sight.run_next.items()
        ],
        "experiments": dict(words),
    }  # fmt: skip


def _ranked(found, sight: Sight) -> list[dict[str, Any]]:
    return [
        {"experiment": name, "distance": distance, "needed": sight.needed.get(name)}
        for name, distance in found
    ]


def unseen(found: Diagnosis, sight: Sight | None) -> list[str]:
    """What the data would not show, without forms of what they did show or was refitted."""
    if sight is None:
        return []
    same = same_as_refitted(found)
    families = {e.family for e in found.search.corrected.effects}
    family = {c.name: c.family for c in found.candidates}
    return [n for n in sight.blind if family.get(n) not in families and n not in same]
