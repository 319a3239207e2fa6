"""The library: effects that are tried on a rotor with a clutch."""

from __future__ import annotations

from ..rigs.effect_candidate import EffectCandidate
from .coil_candidates import of_commands, of_magnets, of_switching
from .contact_candidates import WOUND, giving_way, in_the_long_run, of_speed_and_angle
from .load_candidates import of_the_sensor, on_the_rotor
from .sizes import OF_TESTBED, Sizes
from .winding import Winding


def rotor_candidates(
    beside: tuple[int, ...] = (),
    wound: Winding | None = WOUND,
    lag: str | None = None,
    sizes: Sizes = OF_TESTBED,
) -> tuple[EffectCandidate, ...]:
    """Every effect that is tried, one form after the other.

    `lag`: name of the tolerance to which the clutch's time constant is declared, if it is to one.

    `beside`: further friction surfaces of the same plate (what it drags when off), which give way
    with it.  `wound`: where fits of what gives way after reversals begin; where reversals show
    nothing that does, None: what would show there is then tried as a further form alone.  `sizes`:
    of the clutch and its rotor, beside those of the testbed.
    """
    return (
        *of_speed_and_angle(sizes),
        *giving_way(sizes, wound, beside),
        *in_the_long_run(sizes),
        *on_the_rotor(sizes),
        *of_magnets(sizes),
        *of_switching(sizes, lag),
        *of_commands(sizes),
        *of_the_sensor(sizes),
    )
