"""Declared numbers that are off by more than their tolerance, and what comes down to them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

from ...scenario import Scenario
from ..fitting.predictor import Parameter
from .scenario_predictor import EffectCandidate

#: Family of dry friction off its declared size, and the name of it on clutches.
TORQUE_SCALE = "torque-scale"
#: Name of a lag of the excitation off its declared one, and its family.
TIME_CONSTANT, LAG = "time-constant", "lag"
#: Share by which a lag may be off: lower, upper, typical.
LAGS = (-0.9, 3.0, 0.03)
#: Families that come down to another scale of the torque at a limit of their shape, or of a record:
#: of friction that is never seen at another speed, place or age they do all that a scale does.
AT_A_LIMIT = ("velocity", "position", "thermal", "wear")


def scaled_numbers(declared: Scenario, clutch: int) -> dict[str, float]:
    """Declared numbers [SI], none of them 0, to which a clutch's dry friction is proportional."""
    return _numbers(declared, clutch, declared.clutches[clutch].torque.scaled)


def breaking_numbers(declared: Scenario, clutch: int) -> dict[str, float]:
    """The same for its breakaway alone."""
    return _numbers(declared, clutch, declared.clutches[clutch].torque.breaking)


def _numbers(declared: Scenario, clutch: int, names: Iterable[str]) -> dict[str, float]:
    known = {name: getattr(declared.clutches[clutch].torque, name) for name in names}
    return {f"clutch.{clutch + 1}.torque.{name}": x for name, x in known.items() if x}


def off_by_a_share(
    name: str, numbers: Mapping[str, float], bounds: tuple[float, float, float],
    family: str, acts_on: str, where: Sequence[str], test: str,
) -> EffectCandidate:  # fmt: skip
    """Declared numbers that are all off by one share; `bounds`: its lower, upper, typical."""
    own = f"{name}.share"
    shifts = tuple((own, number, value) for number, value in numbers.items())
    share = Parameter(own, 0.0, *bounds)
    return EffectCandidate(
        name, (share,), ((0.0,),), family, acts_on, tuple(where), test, shifts=shifts
    )


def with_scale(
    library: Iterable[EffectCandidate], declared: Scenario, name: str, most: float,
    where: Sequence[str], test: str,
) -> tuple[EffectCandidate, ...]:  # fmt: skip
    """The library, and the first clutch off its declared friction by a share of `most` or less."""
    numbers = scaled_numbers(declared, 0)
    if not numbers:
        return tuple(library)
    bounds = -0.9, most, 0.02
    scale = off_by_a_share(name, numbers, bounds, TORQUE_SCALE, "friction", where, test)
    return (*holding(library, name, AT_A_LIMIT), scale)


def holding(
    library: Iterable[EffectCandidate], name: str, families: Collection[str]
) -> tuple[EffectCandidate, ...]:
    """The library, of which these families come down to the candidate called `name`."""
    return tuple(
        replace(c, contains=(*c.contains, name)) if c.family in families else c for c in library
    )
