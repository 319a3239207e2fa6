"""How a candidate is made of an effect: what is fitted, from where, and where it would show."""

from __future__ import annotations

from ...effect import Effect
from ..fitting.predictor import Parameter
from .scenario_predictor import EffectCandidate

#: (field, lower, upper, typical) of the parameters to fit.
Field = tuple[str, float, float, float]
#: Waves a turn that are tried where one or two are not enough.
FURTHER_WAVES = (3, 4)


def candidate(
    name: str,
    effect: Effect | None,
    fields: tuple[Field, ...],
    starts: tuple[tuple[float, ...], ...],
    family: str,
    port: str,
    coordinates: tuple[str, ...],
    freed: tuple[Parameter, ...] = (),
    simpler: str = "",
    more: tuple[Effect, ...] = (),
    contains: tuple[str, ...] = (),
    further: bool = False,
) -> EffectCandidate:
    """A candidate; `freed` declared parameters are fitted without their tolerance.

    With `more` effects fields are numbered: ``1.cosine`` of the first, ``2.bias`` of the second.
    """
    effects = (effect, *more)

    def usual(field: str) -> float:
        number, _, own = field.rpartition(".")
        return getattr(effects[int(number or 1) - 1], own, 0.0)

    own = tuple(
        Parameter(f"{name}.{field}", usual(field), low, high, typical)
        for field, low, high, typical in fields
    )
    balances: tuple[str, ...] = ("load",) if port == "load" else ("friction",)
    if port == "sensor":
        balances = ("friction", "load")
    where = tuple(f"{b}:{c}" for b in balances for c in coordinates)
    echoes: tuple[str, ...] = ()
    if port == "breakaway":
        where = tuple(f"breakaway:{c}" for c in coordinates)
        echoes = ("friction:displacement_since_reversal", "friction:acceleration")
    reveals = effect.reveals if effect is not None else "The same torque read by a second sensor."
    named = effect.sizes if effect is not None and not more else ()
    sizes = tuple(f"{name}.{size}" for size in named)
    return EffectCandidate(
        name, (*own, *freed), starts, family, port, where, reveals, effect,
        sizes=sizes, simpler=simpler, more=more, echoes=echoes, contains=contains,
        further=further,
    )  # fmt: skip
