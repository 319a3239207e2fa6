"""Runs that were driven alike and moved apart: no model explains both, and they are no repetition.

Of what differed between them nothing was recorded; a reader who knows it can log it.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..fitting.repeats import ALIKE, AS_LONG
from ..fitting.replay import Replay
from ..recordings.noise import noise_estimate
from ..result import Diagnosis

#: Two runs are driven alike if what drives them differs by no more than this part of it, and begin
#: alike if their starts do by no more than this part of where and how fast they go.
DRIVEN_ALIKE, BEGUN_ALIKE = 0.02, 0.1
#: What is known of a run of an axis.
MOVED = {"position", "speed", "start"}
#: Most pairs that are listed.
LISTED = 3


class Apart(NamedTuple):
    """Two runs and by which part of the motion they differ."""

    one: str
    other: str
    part: float


def moved_apart(replays: Sequence[Replay]) -> list[Apart]:
    """Pairs of runs of one axis that were driven alike and moved apart, farthest first."""
    runs = [r for r in replays if {*r.notes} >= MOVED and "drive" in r.inputs and _driven(r)]
    found = [
        Apart(a.name, b.name, part)
        for a, b in itertools.combinations(runs, 2)
        if _told_the_same(a, b) and (part := _apart(a.notes["speed"], b.notes["speed"])) > ALIKE
    ]
    return sorted(found, key=lambda pair: (-pair.part, pair.one, pair.other))


def moved_apart_sentence(found: Diagnosis) -> str:
    """Sentence on runs that were driven alike and moved apart; "" if none did."""
    split = found.split
    pairs = moved_apart([*found.fitted, *split.select, *split.report])
    if not pairs:
        return ""
    listed = ", ".join(f"{p.one} and {p.other} by {100 * p.part:.0f} %" for p in pairs[:LISTED])
    more = f", and {len(pairs) - LISTED} more pairs" if len(pairs) > LISTED else ""
    return (
        f"Driven alike from the same start some runs moved apart ({listed}{more} of the speed): "
        "they count as no repetition, and nothing that was recorded says why. What was not the "
        "same in them (a load, warmth, a supply) can be logged as a `constant` of each run."
    )


def _driven(replay: Replay) -> bool:
    """Whether what drives a run changes."""
    drive = replay.inputs["drive"]
    return bool(np.std(drive) > ALIKE * np.sqrt(np.mean(drive**2)))


def _told_the_same(a: Replay, b: Replay) -> bool:
    """Whether two runs have the same settings, inputs and start."""
    if a.setting != b.setting or a.inputs.keys() != b.inputs.keys():
        return False
    sizes = a.time.size, b.time.size
    if max(sizes) - min(sizes) > AS_LONG * min(sizes):
        return False
    if any(_apart(a.inputs[name], b.inputs[name]) > DRIVEN_ALIKE for name in a.inputs):
        return False
    ranges = [max(np.ptp(r.notes[name]) for r in (a, b)) for name in ("position", "speed")]
    starts = np.abs(a.notes["start"] - b.notes["start"])
    return bool(np.all(starts <= BEGUN_ALIKE * np.array(ranges)))


def _apart(a: np.ndarray, b: np.ndarray) -> float:
    """Root mean square of a difference, less its noise, over that of the larger."""
    rows = min(a.size, b.size)
    a, b = a[:rows], b[:rows]
    size = max(float(np.mean(x**2)) for x in (a, b))
    apart = float(np.mean((a - b) ** 2)) - noise_estimate(a - b) ** 2
    return float(np.sqrt(max(apart, 0.0) / size)) if size else 0.0
