"""Declared numbers that are off by more than their tolerance, and what comes down to them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ...scenario import Scenario
from ..fitting.predictor import Parameter
from .effect_candidate import EffectCandidate

#: Family of dry friction off its declared size, and the name of it on clutches.
TORQUE_SCALE = "torque-scale"
#: Name of a lag of the excitation off its declared one, and its family.
TIME_CONSTANT, LAG = "time-constant", "lag"
#: Share by which a lag may be off: lower, upper, typical.  Of a robot one of 0.03 was lost among
#: the samples at which clutches let go.
LAGS = (-0.9, 3.0, 0.1)
#: Families that come down to another scale of the torque at a limit of their shape, or of a record:
#: of friction that is never seen at another speed, place or age they do all that a scale does.
AT_A_LIMIT = ("velocity", "position", "thermal", "wear")


def scaled_numbers(declared: Scenario, *clutches: int, breaking: bool = False) -> tuple[str, ...]:
    """Names of declared numbers, none 0, to which dry friction of these clutches is proportional.

    `breaking`: those to which their breakaway alone is.
    """
    found = []
    for k in clutches:
        law = declared.clutches[k].torque
        names = law.breaking if breaking else law.scaled
        found += [f"clutch.{k + 1}.torque.{name}" for name in names if getattr(law, name)]
    return tuple(found)


def shared_numbers(declared: Scenario, shares: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Declared number -> parameter that says by which share it is off.

    `shares` are those of a candidate.  Off by that of a factor is also what this multiplies.
    """
    found = {number: own for own, number in shares}
    for k, clutch in enumerate(declared.clutches, 1):
        law = clutch.torque
        factors = [found.get(f"clutch.{k}.torque.{name}") for name in law.scaled]
        if law.multiplied and factors[0] is not None:
            found |= {f"clutch.{k}.torque.{name}": factors[0] for name in law.multiplied}
    return found


def off_by_a_share(
    name: str, numbers: Iterable[str], bounds: tuple[float, float, float], begin: float,
    family: str, acts_on: str, where: Sequence[str], test: str,
) -> EffectCandidate:  # fmt: skip
    """A candidate by which declared numbers are all off by one share.

    `bounds` are the lower, upper and typical value of the share.  Fits begin at `begin` and its
    negative: a refit has gone to the ends of tolerances, from where no small step leads back, and a
    breakaway that is a little off moves few events.
    """
    own = f"{name}.share"
    share = Parameter(own, 0.0, *bounds)
    starts = tuple((x,) for x in (begin, -begin) if x >= share.lower)
    return EffectCandidate(
        name, (share,), starts, family, acts_on, tuple(where), test, sizes=(own,), declared=True,
        shares=tuple((own, number) for number in numbers),
    )  # fmt: skip


def with_scale(
    library: Iterable[EffectCandidate], declared: Scenario, name: str, most: float,
    where: Sequence[str], test: str, contains: tuple[str, ...] = (),
) -> tuple[EffectCandidate, ...]:  # fmt: skip
    """The library, and all dry friction off the declared one by a share of `most` or less."""
    numbers = scaled_numbers(declared, *range(declared.device.m))
    if not numbers:
        return tuple(library)
    # From farther off torques change by more than a residual counts: no fit keeps such a promise.
    bounds, begin = (-0.9, most, 0.02), 0.05
    scale = off_by_a_share(name, numbers, bounds, begin, TORQUE_SCALE, "friction", where, test)
    holding = (
        replace(c, contains=(*c.contains, name)) if c.family in AT_A_LIMIT else c for c in library
    )
    return (*holding, replace(scale, contains=contains))
