"""A short replay of the robot, and the candidates that are neither friction nor actuator."""

import numpy as np

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.tip.structure import Scales, structure_candidates

TIME = 2e-3 * np.arange(200)


def declared():
    return load(find_model("robot"))


def candidates():
    found = structure_candidates(declared(), Scales(20.0, 0.5, 0.5, 10.0))
    return {c.name: c for c in found}


def force(t):
    """Along x and y [N]."""
    return 30.0 * np.sin(5 * t), 20.0 * np.cos(4 * t)


def replay(**notes):
    x, y = force(TIME)
    commands = {f"command_{i + 1}": np.full(TIME.size, 2.0 * (i < 2)) for i in range(4)}
    state = np.array([[1.2, 2.0, 0.3, -0.2]])
    inputs = {**commands, "force_x": x, "force_y": y}
    return Replay("run", "run", TIME, inputs, {}, notes={
        "start_at": np.array([0]), "states": state,
        "position": np.tile([[1.2], [2.0]], TIME.size), **notes,
    })  # fmt: skip
