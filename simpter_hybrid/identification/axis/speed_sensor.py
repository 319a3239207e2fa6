"""What the sensor of an axis's speed may do wrong: a gyroscope has a zero of its own.

Windows begin at speeds of the record, and so with its error: they are put right with it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ...device import Device
from ..fitting.predictor import Parameter
from ..fitting.replay import Replay
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.sensor_errors import Key
from .signals import AxisSignals

#: The fit's parameter [rad/s or m/s].
OFFSET = "speed-offset.offset"
#: Largest offset that is looked for and a typical one, over the largest speed.
MOST, TYPICAL = 0.5, 0.01
#: Where it shows: friction and springs act on another speed than the one shown.
WHERE = ("time", "speed", "slip_velocity", "position")


def speed_keys(device: Device) -> dict[Key, str]:
    """Signal and field of the speed sensor's error in readings -> its name in a fit."""
    return {(f"speed of {device.coordinates[0]}", "offset"): OFFSET}


def speed_candidates(
    replays: Sequence[Replay], s: AxisSignals, turning: bool
) -> tuple[EffectCandidate, ...]:
    """A zero of the speed that is off; none where no speed was measured."""
    seen = [r.observed[s.speed].values for r in replays if s.speed in r.observed]
    if not seen:
        return ()
    most = max(float(np.quantile(np.abs(values), 0.99)) for values in seen)
    return (speed_offset(most, turning),)


def speed_offset(most: float, turning: bool) -> EffectCandidate:
    """The candidate, on an axis whose speed reaches `most` [rad/s, or m/s of one that is straight].

    A motion in windows shows it by friction and springs, which act on another speed.
    """
    unit = "rad/s" if turning else "m/s"
    offset = Parameter(OFFSET, 0.0, -MOST * most, MOST * most, TYPICAL * most, unit=unit)
    again = "The sensor read while the axis rests, before and after."
    where = tuple(f"force:{coordinate}" for coordinate in WHERE)
    return EffectCandidate(
        "speed-offset", (offset,), ((0.0,),), "speed sensor", "sensor", where, again,
        sizes=(OFFSET,),
    )  # fmt: skip


def begun_right(replay: Replay, values: Mapping[str, float]) -> Replay:
    """The run with the motion that a sensor with such an offset must have seen where it begins."""
    offset = values.get(OFFSET, 0.0)
    if not offset or AxisSignals.speed not in replay.observed:  # then it is the positions' rate
        return replay
    told = replay.start_told[1]  # of the axis itself, whatever its sensor shows
    start = replay.notes["start"] - np.array([0.0, 0.0 if told else offset])
    anew = [tuple(replace(r, speed=r.speed - offset) for r in of)
            for of in (replay.restarts, replay.followed)]  # fmt: skip
    return replace(
        replay, restarts=anew[0], followed=anew[1], notes={**replay.notes, "start": start}
    )
