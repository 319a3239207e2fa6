"""The force that declared motors make of a recorded drive: what friction is a part of."""

from __future__ import annotations

import inspect
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...loads.drive import ForceDrive, VoltageDrive
from ...scenario import Scenario

#: Motors that a recorded drive moves.
Motor = ForceDrive | VoltageDrive


def motors_of(declared: Scenario, coordinate: int = 0) -> tuple[Motor, ...]:
    """The motors on a coordinate."""
    motors = (x for x in declared.loads if isinstance(x, ForceDrive | VoltageDrive))
    return tuple(m for m in motors if int(m.coordinate) == coordinate)


def turned_by(motors: Sequence[Motor]) -> float:
    """Force of motors on one coordinate for each unit of their drive at rest."""
    return sum(
        m.constant / m.resistance if isinstance(m, VoltageDrive) else m.constant for m in motors
    )


def force_by(
    motors: Sequence[Motor], told: np.ndarray, released: np.ndarray, speed: np.ndarray
) -> np.ndarray:
    """Force of motors on one coordinate, by their own laws (samples,) [N m or N].

    Parameters
    ----------
    motors : sequence of ForceDrive or VoltageDrive
    told : ndarray (samples,)
        Voltage or current of the drive, or what its sensor saw.
    released : ndarray (samples,)
        1 where the motor's ends are open.
    speed : ndarray (samples,)
        As recorded: a voltage drives against it.
    """
    rows = np.column_stack([told, np.round(released), speed]).tolist()
    force = np.zeros(told.size)
    for motor in motors:
        law, out, held, qd = motor.functions()["force"], [0.0], [0.0, 0.0], [0.0]
        known = {"held": held, "at_drive_1": 0, "at_open_1": 1, "qd": qd, "Q": out}
        # As the only motor of an axis: lists have one place for it.
        known |= replace(motor, coordinate=0.0).parameters()
        asked = [known[name] for name in inspect.signature(law).parameters]
        for k, (held[0], held[1], qd[0]) in enumerate(rows):  # in place: `asked` holds the lists
            out[0] = 0.0
            law(*asked)
            force[k] += out[0]
    return force
