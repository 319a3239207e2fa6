"""A motor's driver that opens the motor's ends where it is told nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...effects.drive_released import DriveReleased
from ...loads.drive import VoltageDrive
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from ..fitting.replay import Replay
from ..rigs.effect_candidate import EffectCandidate
from .drive import COASTS
from .force_sensor import one_candidate
from .motor import motor_of

#: Up to this part of the most that is told it is nothing: a command is a number, not a reading.
NOTHING = 1e-3
#: An axis moves at more than this part of its largest speed; so many rows of it have to be seen.
MOVES, ROWS = 0.05, 10


def let_go(declared: Scenario, replays: Sequence[Replay]) -> tuple[EffectCandidate, ...]:
    """Candidate: the motor is released while told nothing; none where it never moves so.

    Parameters
    ----------
    declared : Scenario
    replays : sequence of Replay
        Driven by what a driver was told, of which nobody said when it released the motor.
    """
    motor = declared.loads[motor_of(declared)[0]]
    if not isinstance(motor, VoltageDrive) or motor.coasting > 0.0:
        return ()
    if any(isinstance(effect, DriveReleased) for effect in declared.effects):
        return ()
    most = max(float(np.abs(r.inputs["drive"]).max()) for r in replays)
    speeds = [np.abs(r.notes["speed"]) for r in replays]
    moving = MOVES * max(float(speed.max()) for speed in speeds)
    rows = 0
    for replay, speed in zip(replays, speeds, strict=True):
        nothing = np.abs(replay.inputs["drive"]) <= NOTHING * most
        # What only passes through zero is nothing in one row alone.
        stays = nothing & (np.append(nothing[1:], False) | np.append(False, nothing[:-1]))
        rows += int(np.sum(stays & (speed > moving)))
    return (released(motor, NOTHING * most),) if rows >= ROWS else ()


def released(motor: VoltageDrive, below: float) -> EffectCandidate:
    """The candidate; up to `below` a driver is told nothing [V]."""
    turned = motor.constant / motor.resistance
    effect = DriveReleased(coordinate=0, below=below, constant=turned, back=turned * motor.constant)
    share = Parameter("drive-released.share", 0.0, 0.0, 1.0, 0.1)
    about = effect.family, effect.acts_on, COASTS, effect.reveals
    made = one_candidate("drive-released", share, 0.5, *about)
    return replace(made, effect=effect, ends_opened=True)
