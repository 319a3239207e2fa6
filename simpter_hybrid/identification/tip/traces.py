"""Residual torque of every joint along every run, from positions alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import savgol_filter

from ...device import Device
from ...measuring.over_poses import over_poses
from ..fitting.predictor import Predictor
from ..fitting.replay import Replay
from ..recordings.row_step import row_step
from ..recordings.smoothing import derivative, odd
from ..tracing.coordinates import coordinates
from ..tracing.logged import told_apart
from ..tracing.trace import Trace, force_trace

#: Over which the error of a position is fitted by a parabola [s]: its bend is the torque.
WIDTH = 0.3


@dataclass(frozen=True)
class TipTracer:
    """Makes the traces: balances ``joint_1``, ``joint_2`` ...

    Parameters
    ----------
    inertia : tuple of float
        Declared inertia of every joint [kg m^2].
    clutches : int
    device : Device
        Turns the tip force into torques.
    turn : tuple of float
        Period of each joint's position [rad]; inf of one that stays within a turn.
    force : tuple of str
        Signals of the tip force.
    position : str
        Signals of the joints' angles, numbered from 1.
    together : bool
        Two dozen coordinates on a hundred blocks: p-values hold for all of them together.
    """

    inertia: tuple[float, ...]
    clutches: int
    device: Device
    turn: tuple[float, ...]
    force: tuple[str, str] = ("force_x", "force_y")
    position: str = "position"
    together: bool = True

    def __call__(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """Traces of each joint's missing torque: inertia times the bend of the position's error."""
        predicted = predictor.predict(values, replays)
        found: dict[str, list[Trace]] = {}
        for i, replay in enumerate(replays):
            told = {name: np.nan_to_num(series[i]) for name, series in predicted.items()}
            pushes = tip_pushes(self.device, replay, self.force)
            for j in range(len(self.inertia)):
                trace = self._trace(replay, told, j, pushes[:, j])
                found.setdefault(f"joint_{j + 1}", []).append(trace)
        return found

    def _trace(
        self, replay: Replay, told: Mapping[str, np.ndarray], j: int, push: np.ndarray
    ) -> Trace:
        step = row_step(replay.time)
        name = f"{self.position}_{j + 1}"
        error = replay.observed[name].values - told[name]
        missing = self.inertia[j] * bend(error, replay.observed[name].windows, step)
        others = {}
        for k in range(self.clutches):
            others[f"excitation_{k + 1}"] = told[f"excitation_{k + 1}"]
            others[f"slip_{k + 1}"] = np.sign(told[f"torque_{k + 1}"])
        others["push"], others["push_across"] = push
        others["push_rate"] = derivative(push[0], step, WIDTH)
        other = 1 - j if len(self.inertia) == 2 else j
        others["other_position"] = replay.notes["position"][other]
        others["other_acceleration"] = derivative(told[f"speed_{other + 1}"], step, WIDTH)
        friction = told[f"friction_{j + 1}"]
        total = sum(told[f"excitation_{k + 1}"] for k in range(self.clutches))
        along = coordinates(
            replay.time, replay.notes["position"][j], told[f"speed_{j + 1}"], friction,
            np.asarray(total), others, self.turn[j],
        )  # fmt: skip
        logged = told_apart(replay.logged, along)
        return force_trace(missing, friction, along, step, 0.5 * WIDTH, logged)


def tip_pushes(device: Device, replay: Replay, force: Sequence[str]) -> np.ndarray:
    """Torques of the tip force, and of one turned by a quarter (2, joints, samples) [N m]."""
    n = device.n
    turn = over_poses(device, "tip_jacobian", replay.notes["position"].T, 2 * n)
    along_x, along_y = turn.T.reshape(2, n, -1)
    x, y = (replay.inputs[name] for name in force)
    return np.array([along_x * x + along_y * y, along_y * x - along_x * y])


def bend(error: np.ndarray, windows: Sequence[int], step: float) -> np.ndarray:
    """Second derivative of an error by local parabolas, window by window."""
    found = np.zeros(error.size)
    for a, b in zip(windows, (*windows[1:], error.size), strict=True):
        if b - a > 8:
            width = odd(WIDTH / step, b - a)
            found[a:b] = savgol_filter(error[a:b], width, 2, deriv=2, delta=step, mode="interp")
    return found
