"""How candidates on several clutches or joints are made, and where their lack would show."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from ...effect import Effect
from ..fitting.predictor import Parameter
from ..rigs.effect_candidate import EffectCandidate

#: Coordinates on which a residual may depend where the actuator of a clutch lacks something.
SWITCHING = ("excitation", "excitation_rate", "excitation_branch", "torque", "drive")


def of_clutches(m: int, n: int, coordinates: Sequence[str]) -> tuple[str, ...]:
    """Every joint's ``balance:coordinate``: `coordinates`, and excitation and slip per clutch."""
    where = tuple(f"joint_{j + 1}:{c}" for j in range(n) for c in coordinates)
    own = tuple(f"{c}_{i + 1}" for i in range(m) for c in ("excitation", "slip"))
    return where + tuple(f"joint_{j + 1}:{c}" for j in range(n) for c in own)


def made(name: str, fields, effects: tuple[Effect, ...], where) -> EffectCandidate:
    """A candidate of effects of one kind; `fields`: (field, lower, upper, typical, start(s))."""
    own = tuple(
        Parameter(f"{name}.{field}", getattr(effects[0], field.rpartition(".")[2]), low, high, size)
        for field, low, high, size, _ in fields
    )
    begins = (f[4] if isinstance(f[4], tuple) else (f[4],) for f in fields)
    starts = tuple(product(*begins))
    # What a start switches on is begun at the size that the survey's linear step asks for.
    sizes = {field for field, *_, begin in fields if not isinstance(begin, tuple) and begin}
    first, plain = effects[0], name.partition(" by ")[0]
    return EffectCandidate(
        name, own, starts, first.family, first.acts_on, where, first.reveals, first, effects[1:],
        plain=plain if plain != name else "",
        sizes=tuple(p.name for p in own if p.name.removeprefix(f"{name}.") in sizes),
    )  # fmt: skip
