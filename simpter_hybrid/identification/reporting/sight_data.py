"""What the data can show, as plain data: visible, blind to, not separated, and the run to make."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..identifiability_report import Sight
from ..result import Diagnosis
from .sight_sentences import in_classes, otherwise


def sight_data(sight: Sight, found: Diagnosis, words: Mapping[str, str]) -> dict[str, Any]:
    """As the JSON has it; `words` says of each planned experiment what is laid down in it."""
    imitated = {(a, b): part for a, b, part in sight.confused}
    return {
        "visible": dict(sight.visible),
        "blind_to": list(sight.blind),
        "blind_to_classes": in_classes(sight.blind, found.candidates),
        "shown_by": {name: _ranked(runs, sight) for name, runs in sight.reveals.items()},
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
    """What the data would not show, without forms of what they did show."""
    if sight is None:
        return []
    families = {e.family for e in found.search.corrected.effects}
    family = {c.name: c.family for c in found.candidates}
    return [name for name in sight.blind if family.get(name) not in families]
