"""What a report says of the sizes of what was named: that data hardly tell them, or cannot."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..held_out_gains import HeldOutGain
from ..result import Diagnosis
from .held_out_sentences import BREAKAWAY
from .not_shown import unsized_sentence
from .parts_shown import parts_sentence


def sizes_told(
    found: Diagnosis,
    parameters: Sequence[Mapping[str, Any]],
    gains: Sequence[Sequence[HeldOutGain]] = (),
) -> str:
    """Effects without a sure size, parts that may be none, levels that nothing shows."""
    said = (
        unsized_sentence(found, parameters, gains), parts_sentence(found, parameters),
        no_level_sentence(found),
    )  # fmt: skip
    return " ".join(filter(None, said))


def no_level_sentence(found: Diagnosis) -> str:
    """That no run shows a level of breakaway, where an effect on it was named; else ""."""
    effects = found.search.corrected.effects
    names = [e.name for e in effects if any(c.startswith(BREAKAWAY) for c in e.coordinates)]
    if not names:
        return ""
    parts = found.split.fit, found.split.select, found.split.report, found.fitted
    if any(run.breakaways for part in parts for run in part):
        return ""
    return (
        f"No run shows the level of a breakaway, which {' and '.join(names)} would change: what "
        "stays stuck tells only that it is higher. Let ramps of the torque go on until it slips, "
        "after short rests and long ones."
    )
