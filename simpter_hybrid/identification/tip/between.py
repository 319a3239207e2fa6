"""Clutches that feel one another: by their commands, or by the fields of their coils."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import permutations

from ...effects.cross_coupling import CrossCoupling
from ...effects.stray_field import StrayField
from ..rigs.effect_candidate import EffectCandidate
from .made import SWITCHING, made, of_clutches

#: (lower, upper, typical, start) of a gain.
GAIN = (-0.5, 0.5, 0.01, 0.0)


def between_clutches(m: int, n: int) -> Iterator[EffectCandidate]:
    """Each clutch feels the next one, the one before, all others alike, or each by its own gain."""
    pairs = list(permutations(range(m), 2))
    if not pairs:
        return
    where = of_clutches(m, n, SWITCHING)
    labels = tuple(f"{i + 1} from {j + 1}" for i, j in pairs)
    each = tuple((f"{label}.gain", *GAIN) for label in labels)
    commands = tuple(CrossCoupling(clutch=i, neighbour=float(j)) for i, j in pairs)
    does = ("other-commands", "other-commands by clutch")
    found = made("cross-coupling", each, commands, where)
    yield replace(found, labels=labels, contains=does)
    alike = {"cross-coupling-others": pairs}
    if m > 2:
        alike["cross-coupling-next"] = [(i, (i + 1) % m) for i in range(m)]
        alike["cross-coupling-previous"] = [(i, (i - 1) % m) for i in range(m)]
    for name, felt in alike.items():
        yield made(name, (("gain", *GAIN),), _fields(felt), where)
    found = made("cross-coupling-fields", each, _fields(pairs), where)
    yield replace(found, labels=labels, contains=tuple(alike))


def _fields(felt: list[tuple[int, int]]) -> tuple[StrayField, ...]:
    return tuple(StrayField(clutch=i, neighbour=float(j)) for i, j in felt)
