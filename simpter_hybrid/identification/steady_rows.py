"""Candidates by a slip angle, kept where there is one: on clutches whose map is constant."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..checks.angle_check import changing_rows, goes_by_angle
from ..scenario import Scenario
from .rigs.effect_candidate import EffectCandidate


def where_rows_are_steady(
    candidates: Sequence[EffectCandidate], declared: Scenario
) -> tuple[EffectCandidate, ...]:
    """The candidates without effects that a scenario would be refused with.

    Parameters
    ----------
    candidates : sequence of EffectCandidate
    declared : Scenario
        Of a device whose clutch map may change with the pose.
    """
    changing = changing_rows(declared.device, declared.q)
    if not changing:
        return tuple(candidates)
    steady = [str(i + 1) for i in range(declared.device.m) if i not in changing]
    found: list[EffectCandidate] = []
    gone = set()
    for candidate in candidates:
        if not any(e.clutch in changing and goes_by_angle(e) for e in candidate.effects()):
            found.append(candidate)
        elif candidate.places and steady:
            found.append(candidate.only(steady))
        else:
            gone.add(candidate.name)
    return tuple(replace(c, plain="") if c.plain in gone else c for c in found)
