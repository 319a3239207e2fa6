"""Does a tester's force do work on a device that only rubs?  Against its motion it would not."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...loads.drive import ForceDrive, VoltageDrive
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..recordings.recording import Recording
from .prescribed_replays import PrescribedSignals

#: A force that does less than this part of all work (of which some is the device's, signed) has the
#: wrong sign: an elastic part gives back what it took, and friction nothing.
LEAST = -0.25
#: ... where at least this part of the way is gone in either direction: in one a weight may sink.
EITHER_WAY = 0.2


def check_work(
    parts: Mapping[str, Sequence[Replay]], recording: Recording, declared: Scenario, inertia: float
) -> None:
    """Check that the force of the tester takes the device along, and not the other way round.

    Raises
    ------
    InvalidInput
        If of a model that has motors and friction alone it does negative work in a motion that
        goes both ways.
    """
    motors = all(isinstance(load, ForceDrive | VoltageDrive) for load in declared.loads)
    if not motors or any(effect.acts_on == "load" for effect in declared.effects):
        return  # a weight or a spring gives work; a motor is off here
    signals = PrescribedSignals()
    powers, speeds = [], []
    for replay in (r for replays in parts.values() for r in replays):
        seen, speed = replay.observed[signals.force], replay.notes["speed"]
        force = seen.values - inertia * replay.notes["acceleration"]
        powers.append(force * speed)
        speeds.append(speed)
    power, speed = np.concatenate(powers), np.concatenate(speeds)
    forth, way = float(speed[speed > 0.0].sum()), float(np.abs(speed).sum())
    every = float(np.abs(power).sum())
    if not every or not EITHER_WAY <= forth / way <= 1.0 - EITHER_WAY:
        return
    if (done := float(power.sum()) / every) < LEAST:
        what = "the tester's force does negative work on a device that only rubs"
        right = (
            "more than 0: the other sign, of the force or of the motion; or a [[loads]] in the "
            "model that drives"
        )
        where = f"channels.{signals.force}.sign"
        got = f"{100 * done:.0f} % of all the work it does, either way"
        raise InvalidInput([Problem(recording.map.source, where, what, got, right)])
