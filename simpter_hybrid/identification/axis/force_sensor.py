"""The sensor that saw what drives an axis: what it shows, and what may be wrong with it.

A sensor is no part of a scenario: the record is put right before it drives the model.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...device import Device
from ..fitting.predictor import Parameter
from ..fitting.replay import Replay
from ..recordings.row_step import row_step
from ..recordings.smoothing import lagged
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.sensor_errors import Key

#: Fit's parameters of a sensed drive, and their fields in readings.  An offset is fitted as a
#: constant force: no motion tells one from the other.
SENSOR = (
    ("force-gain.gain", "gain"), ("force-delay.delay", "delay"), ("force-lag.lag", "filter"),
    ("force-offset.offset", "offset"),
)  # fmt: skip
#: Those of `SENSOR` that say when the sensor shows the drive: its delay and its lag.
TIMING = ("force-delay.delay", "force-lag.lag")
#: Input of a replay that says by how much its drive is shown late [s].
LATE = "late"
#: Coordinates on which a residual depends where all forces are off by a gain, or come late.
SCALED, TIMED = ("torque", "acceleration", "direction"), ("slip_velocity", "speed", "acceleration")
#: Largest delay, and lag of a sensor, that are looked for [s], and a typical one.
LONGEST, TYPICAL = 0.05, 0.002


def force_keys(device: Device) -> dict[Key, str]:
    """Signal and field of every error of the force's sensor in readings -> its name in a fit."""
    return {(f"load on {device.coordinates[0]}", field): name for name, field in SENSOR}


def shown(time: np.ndarray, force: np.ndarray, values: Mapping[str, float]) -> np.ndarray:
    """Force (samples,) that a sensor with such errors shows of the true `force`."""
    gain, late, lag, offset = (values.get(name, 0.0) for name, _ in SENSOR)
    if late != 0.0:
        force = np.interp(time - late, time, force)
    if lag > 0.0:
        samples = lag / row_step(time)
        force = force[0] + lagged(force - force[0], samples)
    return (1.0 + gain) * force + offset


def unshown(
    time: np.ndarray, force: np.ndarray, values: Mapping[str, float], apart: float = 0.0
) -> np.ndarray:
    """Force (samples,) that a sensor with such errors shows as `force`: the inverse of `shown`.

    A lag is undone by the slope of `force`, taken over `apart` before and after [s] or, if rows are
    farther apart, from row to row.
    """
    gain, late, lag, offset = (values.get(name, 0.0) for name, _ in SENSOR)
    force = (force - offset) / (1.0 + gain)
    if lag > 0.0:
        force = force + lag * _slope(force, time, apart)
    return np.interp(time + late, time, force) if late != 0.0 else force


def _slope(values: np.ndarray, time: np.ndarray, apart: float) -> np.ndarray:
    rows = round(apart / row_step(time))
    if rows <= 1:
        return np.gradient(values, time)
    index = np.arange(values.size)
    first, last = np.maximum(index - rows, 0), np.minimum(index + rows, values.size - 1)
    return (values[last] - values[first]) / (time[last] - time[first])


def sensed(replay: Replay, values: Mapping[str, float]) -> Replay:
    """The run with the drive that a sensor with such errors must have seen.

    Parameters
    ----------
    replay : Replay
        Its input ``drive`` is as the sensor showed it.
    values : mapping of str to float
        ``force-gain.gain`` (relative), ``force-delay.delay``, ``force-lag.lag`` [s] and
        ``force-offset.offset`` [N or N m], as far as there are any.
    """
    if all(values.get(name, 0.0) == 0.0 for name, _ in SENSOR):
        return replay
    late = values.get("force-delay.delay", 0.0)
    at_once = {**values, "force-delay.delay": 0.0}
    drive = unshown(replay.time, replay.inputs["drive"], at_once)
    by = np.full(replay.time.size, late)
    return replace(replay, inputs={**replay.inputs, "drive": drive, LATE: by})


def gain_candidate() -> EffectCandidate:
    """A sensor that shows so much more than there is."""
    gain = Parameter("force-gain.gain", 0.0, -0.5, 1.0, 0.01)
    again = "The same force read by a second sensor, or a known weight hung on."
    return one_candidate("force-gain", gain, 0.0, "drive gain", "sensor", SCALED, again)


def timing_candidates() -> tuple[EffectCandidate, EffectCandidate]:
    """A sensor of force that shows it late, or through a lag."""
    late = Parameter("force-delay.delay", 0.0, -LONGEST, LONGEST, TYPICAL, unit="s")
    lag = Parameter("force-lag.lag", 0.0, 0.0, LONGEST, TYPICAL, unit="s")
    rest = "drive timing", "sensor", TIMED
    again = "A blow or a step of the force, against the motion that it makes."
    return (
        one_candidate("force-delay", late, 0.0, *rest, again),
        one_candidate("force-lag", lag, TYPICAL, *rest, again),
    )


def one_candidate(
    name, parameter, start, family, acts_on, coordinates, experiment
) -> EffectCandidate:
    where = tuple(f"force:{c}" for c in coordinates)
    sizes = (parameter.name,)
    return EffectCandidate(
        name, (parameter,), ((start,),), family, acts_on, where, experiment, sizes=sizes
    )
