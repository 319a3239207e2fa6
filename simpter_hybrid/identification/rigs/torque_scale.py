"""Friction that is off its declared size by more than its tolerance, and what comes down to it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ...scenario import Scenario
from ..fitting.predictor import Parameter
from .scenario_predictor import EffectCandidate

#: Family of all candidates here, and the name of one on clutches.
TORQUE_SCALE = "torque-scale"
#: Families that come down to another scale of the torque at a limit of their shape, or of a record:
#: of friction that is never seen at another speed, place or age they do all that a scale does.
AT_A_LIMIT = ("velocity", "position", "thermal", "wear")


def scaled_numbers(declared: Scenario, clutch: int) -> dict[str, float]:
    """Declared numbers [SI], none of them 0, to which a clutch's dry friction is proportional."""
    law = declared.clutches[clutch].torque
    numbers = {name: getattr(law, name) for name in law.scaled}
    return {f"clutch.{clutch + 1}.torque.{name}": x for name, x in numbers.items() if x}


def with_scale(
    library: Iterable[EffectCandidate], declared: Scenario, name: str, most: float,
    where: Sequence[str], test: str,
) -> tuple[EffectCandidate, ...]:  # fmt: skip
    """The library, and the first clutch off its declared friction by a share of `most` or less."""
    own = f"{name}.share"
    shifts = tuple((own, number, x) for number, x in scaled_numbers(declared, 0).items())
    if not shifts:
        return tuple(library)
    given = (Parameter(own, 0.0, -0.9, most, 0.02),), ((0.0,),), TORQUE_SCALE, "friction"
    scale = EffectCandidate(name, *given, tuple(where), test, shifts=shifts)
    return (
        *(
            replace(c, contains=(*c.contains, name)) if c.family in AT_A_LIMIT else c
            for c in library
        ),
        scale,
    )
