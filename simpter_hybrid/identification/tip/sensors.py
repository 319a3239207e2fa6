"""What a force sensor at the tip and the sensors of the angles may do wrong.

A sensor is no part of a scenario: the record is put right before it drives the model, and the
model's angles are read as the sensors would.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...device import Device
from ...measuring.readings import force_axes
from ..fitting.replay import Replay
from ..rigs.sensor_errors import CROSSTALK as FORCE_CROSSTALK
from ..rigs.sensor_errors import TURNED as FORCE_TURNED
from ..rigs.sensor_errors import Key

#: Names of these candidates; ``angle-gain`` has gains and offsets.
GAIN, TURNED, DELAY, OFFSET = "force-gain", "force-turned", "force-delay", "force-offset"
CROSSTALK = "force-crosstalk"
ANGLES = ("angle-offset", "angle-gain")
SENSORS = (GAIN, TURNED, CROSSTALK, DELAY, OFFSET, *ANGLES)


def sensed(replay: Replay, values: Mapping[str, float], signals) -> Replay:
    """The run with the force and the motion that such sensors must have seen.

    Parameters
    ----------
    replay : Replay
    values : mapping of str to float
        ``force-gain.x``, ``force-gain.y`` (relative), ``force-turned.angle`` [rad],
        ``force-crosstalk.x`` and ``.y`` (what each axis shows of the force along the other),
        ``force-delay.delay`` [s] and ``angle-gain.1.gain`` and so on, as far as they are fitted;
        declared are ``force-offset.x`` [N], ``force-delay.x`` [s] and those of y.  An offset that
        is fitted is a load instead, a push on the tip.
    signals : TipSignals
    """
    if not any(name.partition(".")[0] in SENSORS for name in values):
        return replay
    inputs, notes = dict(replay.inputs), dict(replay.notes)
    names = signals.force
    force = _true_force(replay.time, [inputs[name] for name in names], values)
    exact = all(f is inputs[name] for f, name in zip(force, names, strict=True))
    read = replay.inputs if exact else inputs | dict(zip(names, force, strict=True))
    scale, shift = _angles(replay, values)
    if np.any(scale != 1.0) or np.any(shift != 0.0):
        n = scale.size
        states = notes["states"].copy()
        states[:, :n] = (states[:, :n] - shift) / scale
        states[:, n:] = states[:, n:] / scale
        notes["states"] = states
        notes["position"] = (notes["position"] - shift[:, None]) / scale[:, None]
    return replace(replay, inputs=read, notes=notes)


def _true_force(
    time: np.ndarray, force: list[np.ndarray], values: Mapping[str, float]
) -> list[np.ndarray]:
    """Force on the tip along x and y of what its sensor showed; the same arrays if it is exact."""
    if any(f"{OFFSET}.{k}" in values for k in "xy"):
        force = [f - values.get(f"{OFFSET}.{k}", 0.0) for f, k in zip(force, "xy", strict=True)]
    if any(f"{GAIN}.{k}" in values for k in "xy"):
        gain = [1.0 + values.get(f"{GAIN}.{k}", 0.0) for k in "xy"]
        force = [f / g for f, g in zip(force, gain, strict=True)]
    if any(f"{DELAY}.{k}" in values for k in ("delay", "x", "y")):
        both = values.get(f"{DELAY}.delay", 0.0)
        late = [both + values.get(f"{DELAY}.{k}", 0.0) for k in "xy"]
        force = [np.interp(time + d, time, f) for f, d in zip(force, late, strict=True)]
    if any(f"{CROSSTALK}.{k}" in values for k in "xy"):
        x, y = (values.get(f"{CROSSTALK}.{k}", 0.0) for k in "xy")
        whole = 1.0 - x * y
        force = [(force[0] - x * force[1]) / whole, (force[1] - y * force[0]) / whole]
    if f"{TURNED}.angle" in values:
        c, s = np.cos(values[f"{TURNED}.angle"]), np.sin(values[f"{TURNED}.angle"])
        force = [c * force[0] + s * force[1], c * force[1] - s * force[0]]
    return force


def sensor_keys(device: Device) -> dict[Key, str]:
    """Signal and field of every error of these sensors in readings -> its name in a fit."""
    found: dict[Key, str] = {FORCE_TURNED: f"{TURNED}.angle"}
    found |= {key: f"{CROSSTALK}.{k}" for key, k in zip(FORCE_CROSSTALK, "xy", strict=True)}
    for j, name in enumerate(device.coordinates):
        found |= {(name, field): f"angle-gain.{j + 1}.{field}" for field in ("gain", "offset")}
    for k in "xy":
        own = (("gain", GAIN), ("offset", OFFSET), ("delay", DELAY))
        found |= {(f"tip force {k}", field): f"{of}.{k}" for field, of in own}
    return found


def sensor_errors(values: Mapping[str, float], device: Device) -> dict[Key, float]:
    """Fitted errors of the sensors of angles and tip force, as ``[readings]`` say them [SI]."""
    found = {key: values.get(name, 0.0) for key, name in sensor_keys(device).items()}
    for j, name in enumerate(device.coordinates):
        found[name, "offset"] += values.get(f"angle-offset.{j + 1}.offset", 0.0)
    axes = force_axes(found[FORCE_TURNED], *(found[key] for key in FORCE_CROSSTALK))
    pushes = (axes @ [values.get(f"{OFFSET}.push_{k}", 0.0) for k in "xy"]).tolist()
    for k, push in zip("xy", pushes, strict=True):
        signal = f"tip force {k}"
        # A push on the tip that the sensor lacks, as its wrong axes and gains would show it.
        found[signal, "offset"] -= (1.0 + found[signal, "gain"]) * push
        found[signal, "delay"] += values.get(f"{DELAY}.delay", 0.0)
    return found


def read_angles(
    replay: Replay, values: Mapping[str, float], channels: dict[str, np.ndarray], position: str
) -> None:
    """Turn predicted angles into what the sensors would show, in place."""
    if not any(name.partition(".")[0] in ANGLES for name in values):
        return
    scale, shift = _angles(replay, values)
    for j in range(scale.size):
        name = f"{position}_{j + 1}"
        channels[name] = channels[name] * scale[j] + shift[j]


def _angles(replay: Replay, values: Mapping[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """Slope and offset of each angle's sensor."""
    n = len(replay.notes["position"])
    scale, shift = np.ones(n), np.zeros(n)
    for name in ANGLES:
        for j in range(n):
            scale[j] += values.get(f"{name}.{j + 1}.gain", 0.0)
            shift[j] += values.get(f"{name}.{j + 1}.offset", 0.0)
    return scale, shift
