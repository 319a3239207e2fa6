"""What is tried on a declared rotor: effects, and what was declared off its tolerance."""

from __future__ import annotations

from dataclasses import replace

from ...checks.law_check import least_breakaway
from ...effects.dwell_breakaway import DwellBreakaway
from ...scenario import Scenario
from ..rigs.candidate import ECHOES
from ..rigs.declared_off import (
    LAG,
    LAGS,
    TIME_CONSTANT,
    TORQUE_SCALE,
    off_by_a_share,
    scaled_numbers,
    with_scale,
)
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.late_commands import late_commands
from .candidates import rotor_candidates
from .coil_candidates import SWITCHING
from .contact_candidates import WOUND
from .sizes import SPEED, sizes_of
from .winding import Winding

#: A breakaway torque that is another multiple of the declared one.
BREAKAWAY_SCALE = "breakaway-scale"
#: The declared number that lags.
TIME_CONSTANT_OF = "clutch.1.time_constant"
LEVELS = "Torque ramps to breakaway at some levels of the command."
SLIPPING = "Hold the rotor, and raise its torque at some levels of the command until it slips."
STEPS = "Steps of the command up and down while the clutch slips."


def rotor_library(
    declared: Scenario,
    beside: tuple[int, ...] = (),
    wound: Winding | None = WOUND,
    speed: float = SPEED,
) -> tuple[EffectCandidate, ...]:
    """All effects (`rotor_candidates`), then what is declared of the clutch off, and a delay."""
    lag, sizes = _declared_lag(declared), sizes_of(declared, speed)
    known = rotor_candidates(beside=beside, wound=wound, lag=lag, sizes=sizes)
    pressed = "friction:torque", "friction:excitation"
    # With the slip torque refitted back it is one of breakaway alone.
    within = (BREAKAWAY_SCALE,)
    known = with_scale(known, declared, TORQUE_SCALE, 2.0, pressed, SLIPPING, within)
    late = late_commands(declared, (0,), [f"friction:{c}" for c in SWITCHING], STEPS)
    return (*known, *_breakaway(declared), *_lag(declared), late)


def _breakaway(declared: Scenario) -> tuple[EffectCandidate, ...]:
    """A breakaway that is off, but never below the slip torque."""
    every = range(declared.device.m)  # what drags when off belongs to the same plate
    numbers = scaled_numbers(declared, *every, breaking=True)
    if not numbers:
        return ()
    clutch = declared.clutches[0]
    least = 1.0 / least_breakaway(clutch.torque, clutch.full_scale) - 1.0
    where = "breakaway:rest", "breakaway:level"
    bounds = min(least, 0.0), 2.0, 0.02
    # Of ramps that end before it, or rests that are all alike, a form of what grows with rest.
    family = DwellBreakaway.family
    one = off_by_a_share(BREAKAWAY_SCALE, numbers, bounds, 0.2, family, "breakaway", where, LEVELS)
    return (replace(one, echoes=ECHOES),)


def _declared_lag(declared: Scenario) -> str | None:
    """Name of the tolerance that holds the time constant of the clutch alone."""
    groups = declared.notes.get("tolerances", ())
    return next((g["name"] for g in groups if list(g["parameters"]) == [TIME_CONSTANT_OF]), None)


def _lag(declared: Scenario) -> tuple[EffectCandidate, ...]:
    if declared.clutches[0].time_constant == 0.0:
        return ()
    numbers, where = [TIME_CONSTANT_OF], [f"friction:{c}" for c in SWITCHING]
    return (off_by_a_share(TIME_CONSTANT, numbers, LAGS, 0.3, LAG, "actuator", where, STEPS),)
