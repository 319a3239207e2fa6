"""What the moving part of a report shows: poses, modes and readings at many instants."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..measuring.desired_path import desired_path
from ..measuring.sampling import Samples, sample
from ..plots import Display, drawing_of
from ..plots.style import mode_spans
from ..scenario import Scenario
from ..trajectory import Trajectory

#: Frames of the animation.
FRAMES = 600


def rounded(values: np.ndarray, digits: int = 4) -> list:
    """Numbers as nested lists, short."""
    return np.round(np.asarray(values, dtype=float), digits).tolist()


def animation(trajectory: Trajectory, display: Display, frames: int = FRAMES) -> dict[str, Any]:
    """The report's data: one entry a frame, taken after any event there.

    Lengths and torques are in the units of ``display``.
    """
    scenario = trajectory.scenario
    device, t_end = scenario.device, trajectory.t_end
    times = np.union1d(np.linspace(0.0, t_end, frames), [e.t for e in trajectory.events])
    s = sample(trajectory, times)
    slip_unit, torque_unit = device.surface_units
    length, torque = display.factor("m"), display.factor(torque_unit)
    return {
        "t": rounded(s.t, 6),
        "t_end": t_end,
        "surfaces": list(device.surfaces),
        "mode": s.mode.tolist(),
        "slip": rounded(display.factor(slip_unit) * s.slip),
        "tau": rounded(torque * s.tau),
        "limit": rounded(torque * s.tau_break),
        "unique": s.unique.astype(int).tolist(),
        "excitation": rounded(s.excitation, 3),
        "units": {
            "torque": display.unit(torque_unit),
            "length": display.unit("m"),
            "slip": display.unit(slip_unit),
        },
        "spans": [
            [[round(a, 6), round(b, 6), code] for a, b, code in mode_spans(trajectory, i)]
            for i in range(device.m)
        ],
        "events": [
            {"t": e.t, "kind": e.kind, "clutches": list(e.clutches)} for e in trajectory.events
        ],
        **_poses(scenario, s, length),
    }


def _poses(scenario: Scenario, s: Samples, length: float) -> dict[str, list]:
    """Where the device is in every frame: drawn as far as it can be, else its coordinates."""
    device = scenario.device
    data: dict[str, list] = {"links": [], "tip": [], "path": [], "coordinates": []}
    if drawing_of(device, s.q[0]):
        data["links"] = [
            [rounded(length * np.array(line)) for line in drawing_of(device, q)] for q in s.q
        ]
    if s.tip is not None:
        data["tip"] = rounded(length * s.tip)
        path = desired_path(scenario)
        data["path"] = [] if path is None else rounded(length * path.outline(s.tip))
    if not data["links"] and not data["tip"]:
        data["coordinates"] = [
            {"name": name, "value": rounded(column, 5)}
            for name, column in zip(device.coordinates, s.q.T, strict=True)
        ]
    return data
