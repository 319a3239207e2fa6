"""Numbers of a model whose zero has no meaning: where a spring is unloaded, where a mass hangs."""

from __future__ import annotations

from collections.abc import Sequence

from ...devices.one_axis import OneAxis
from ...effects.spring_force import SpringForce
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from .effect_candidate import EffectCandidate

#: How their names in the parameter vector end.
ZEROS = (".SpringForce.rest", ".BiasForce.bias", "device.hanging")
#: The zero of an axis's position, by which all its places are off together.
OF_POSITION = "zero of the position"
#: A change of it that matters, as a part of what is travelled.
PART = 0.01


def are_zeros(numbers: Sequence[str]) -> bool:
    """Whether all these numbers of a model are such: a factor is no way to change them."""
    return all(number.endswith(ZEROS) for number in numbers)


def zero_of_position(declared: Scenario, travel: float, turning: bool) -> EffectCandidate | None:
    """The zero of an axis's position, as a number that a run may have of its own.

    None where no place is declared, or a tolerance speaks of one: then that is asked.

    Parameters
    ----------
    declared : Scenario
    travel : float
        In the record [rad or m].
    turning : bool
        Whether the position is an angle.
    """
    places = [
        f"effect.{k}.SpringForce.rest"
        for k, effect in enumerate(declared.effects, 1)
        if isinstance(effect, SpringForce) and effect.coordinate == 0
    ]
    if isinstance(declared.device, OneAxis) and declared.device.weight != 0.0:
        places.append("device.hanging")
    known = {name for t in declared.notes.get("tolerances", ()) for name in t["parameters"]}
    if not places or known.intersection(places):
        return None
    unit = "rad" if turning else "m"
    zero = Parameter(OF_POSITION, 0.0, -travel, travel, PART * travel, unit=unit, signed=True)
    shifts = tuple((OF_POSITION, place, 1.0) for place in places)
    return EffectCandidate(OF_POSITION, (zero,), ((0.0,),), "zero", "load", (), shifts=shifts)
