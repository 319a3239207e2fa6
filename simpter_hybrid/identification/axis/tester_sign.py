"""Does a tester's force go with the motion, as it has to on a device that rubs?"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...loads.drive import ForceDrive, VoltageDrive
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..recordings.recording import Recording
from .prescribed_replays import PrescribedSignals

#: A part of the force that turns round with the motion and is at least this part of all of it has
#: the wrong sign where it goes against the motion.
CLEARLY = 0.3
#: ... where at least this part of the rows go in either direction: in one a weight may sink.
EITHER_WAY = 0.2
#: Where speeds are so alike that they go along with the direction, no drag is told from friction.
ALIKE = 0.98


def check_sign(
    parts: Mapping[str, Sequence[Replay]], recording: Recording, declared: Scenario
) -> None:
    """Check that what turns round with the motion, of a tester's force, goes with it.

    Raises
    ------
    InvalidInput
        If of a model that has motors and friction alone it goes against it.
    """
    motors = all(isinstance(load, ForceDrive | VoltageDrive) for load in declared.loads)
    if not motors or any(effect.acts_on == "load" for effect in declared.effects):
        return
    force = PrescribedSignals().force
    replays = [r for some in parts.values() for r in some]
    keep = [r.observed[force].keep & (r.notes["speed"] != 0.0) for r in replays]
    seen = [r.observed[force].values for r in replays]
    told, position, speed, bent = (
        np.concatenate([x[k] for x, k in zip(every, keep, strict=True)])
        for every in (seen, *([r.notes[n] for r in replays] for n in MOTION))
    )
    if not told.size or not EITHER_WAY <= np.mean(speed > 0.0) <= 1.0 - EITHER_WAY:
        return
    part = turning_round(told, position, speed, bent) / float(np.std(told))
    if part < -CLEARLY:
        what = "the tester's force goes against the motion where a device only rubs"
        right = (
            "more than 0: the other sign, of the force or of the motion; or what drives, in the "
            "model's loads or effects"
        )
        got = f"{part:.2f} times the deviation of the force turns round with the motion"
        where = f"channels.{force}.sign"
        raise InvalidInput([Problem(recording.map.source, where, what, got, right)])


#: What is known of a motion.
MOTION = ("position", "speed", "acceleration")


def turning_round(
    force: np.ndarray, position: np.ndarray, speed: np.ndarray, bent: np.ndarray
) -> float:
    """The part of a force that has the direction of the motion [N or N m], by linear regression.

    Inertia, a spring, a drag and a weight are told from it: a motion that is shown late makes a
    drag of inertia.
    """
    way = np.sign(speed)
    columns = [way, bent, position - position.mean(), np.ones(way.size)]
    if np.corrcoef(way, speed)[0, 1] < ALIKE:
        columns.append(speed)
    found, *_ = np.linalg.lstsq(np.column_stack(columns), force, rcond=None)
    return float(found[0])
