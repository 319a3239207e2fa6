"""What may be wrong with the set points of an axis's own servo: they come late."""

from __future__ import annotations

from ...controllers.axis_servo import PositionServo
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from ..rigs.effect_candidate import EffectCandidate
from .force_sensor import LONGEST, TIMED, TYPICAL

FAMILY = "set-point timing"
DELAY = "reference-delay.delay"


def set_point_candidates(declared: Scenario) -> tuple[EffectCandidate, ...]:
    """Set points that reach the servo after a dead time (a bus, a frame of pulses).

    To a servo that has no speed of them it looks as drag does, of ``proportional delay``; not where
    they stand still, nor if it is let go.
    """
    if not declared.controllers or not isinstance(declared.controllers[0][0], PositionServo):
        return ()  # the stage that is played back stands first
    late = Parameter(DELAY, 0.0, 0.0, LONGEST, TYPICAL, unit="s")
    where = tuple(f"force:{c}" for c in TIMED)
    again = "A step of the set point: how long until the axis moves."
    return (
        EffectCandidate(
            "reference-delay", (late,), ((TYPICAL,),), FAMILY, "actuator", where, again,
            sizes=(DELAY,), shifts=((DELAY, "controller.1.delay", 1.0),),
        ),
    )  # fmt: skip
