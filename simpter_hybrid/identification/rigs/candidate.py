"""How a candidate is made of an effect: what is fitted, from where, and where it would show."""

from __future__ import annotations

from ...effect import Effect
from ..fitting.predictor import Parameter
from .effect_candidate import EffectCandidate

#: (field, lower, upper, typical) of the parameters to fit.
Field = tuple[str, float, float, float]
#: Waves a turn that are tried where one or two are not enough.
FURTHER_WAVES = (3, 4)
#: Where what goes by the speed shows.
MOVING = ("speed", "slip_velocity")
#: Where what acts on a breakaway shows beside it.
ECHOES = ("friction:displacement_since_reversal", "friction:acceleration")


def candidate(
    name: str,
    effect: Effect,
    fields: tuple[Field, ...],
    starts: tuple[tuple[float, ...], ...],
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
    fitted = {p.name for p in own}
    balance = effect.acts_on if effect.acts_on in ("load", "breakaway") else "friction"
    breaks = effect.acts_on == "breakaway"
    return EffectCandidate(
        name, (*own, *freed), starts, effect.family, effect.acts_on,
        tuple(f"{balance}:{c}" for c in coordinates), effect.reveals, effect,
        sizes=() if more else tuple(n for s in effect.sizes if (n := f"{name}.{s}") in fitted),
        simpler=simpler, more=more, echoes=ECHOES if breaks else (), contains=contains,
        further=further,
    )  # fmt: skip


def sensor_candidate(
    name: str,
    field: Field,
    start: float,
    coordinates: tuple[str, ...],
    unit: str = "",
    balances: tuple[str, ...] = ("friction", "load"),
) -> EffectCandidate:
    """A candidate error of a torque sensor; that of the clutch's torque shows in both balances."""
    one = Parameter(f"{name}.{field[0]}", 0.0, *field[1:], unit=unit)
    where = tuple(f"{balance}:{c}" for balance in balances for c in coordinates)
    read = "The same torque read by a second sensor."
    return EffectCandidate(name, (one,), ((start,),), name, "sensor", where, read)
