"""What a force sensor at the tip and the sensors of the angles may do wrong.

A sensor is no part of a scenario: the record is put right before it drives the model, and the
model's angles are read as the sensors would.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from .replay import Replay

#: Note of a replay: its record as the model reads it.
PACKED = "record"
#: Names of these candidates; ``angle-gain`` has gains and offsets.
GAIN, TURNED, DELAY = "force-gain", "force-turned", "force-delay"
ANGLES = ("angle-offset", "angle-gain")
SENSORS = (GAIN, TURNED, DELAY, *ANGLES)


def sensed(replay: Replay, values: Mapping[str, float], signals) -> Replay:
    """The run with the force and the motion that such sensors must have seen.

    Parameters
    ----------
    replay : Replay
    values : mapping of str to float
        ``force-gain.x``, ``force-gain.y`` (relative), ``force-turned.angle`` [rad],
        ``force-delay.delay`` [s] and ``angle-gain.1.gain`` and so on, as far as they are fitted.
    signals : TipSignals
    """
    if not any(name.partition(".")[0] in SENSORS for name in values):
        return replay
    inputs, notes = dict(replay.inputs), dict(replay.notes)
    names = signals.force
    force = [inputs[name] for name in names]
    if f"{GAIN}.x" in values:
        force = [f / (1.0 + values[f"{GAIN}.{k}"]) for f, k in zip(force, "xy", strict=True)]
    if f"{TURNED}.angle" in values:
        c, s = np.cos(values[f"{TURNED}.angle"]), np.sin(values[f"{TURNED}.angle"])
        force = [c * force[0] + s * force[1], c * force[1] - s * force[0]]
    if f"{DELAY}.delay" in values:
        at = replay.time + values[f"{DELAY}.delay"]
        force = [np.interp(at, replay.time, f) for f in force]
    if any(f is not inputs[name] for f, name in zip(force, names, strict=True)):
        notes.pop(PACKED, None)
    inputs |= dict(zip(names, force, strict=True))
    scale, shift = _angles(replay, values)
    if np.any(scale != 1.0) or np.any(shift != 0.0):
        n = scale.size
        states = notes["states"].copy()
        states[:, :n] = (states[:, :n] - shift) / scale
        states[:, n:] = states[:, n:] / scale
        notes["states"] = states
        notes["position"] = (notes["position"] - shift[:, None]) / scale[:, None]
    return replace(replay, inputs=inputs, notes=notes)


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
