"""Residual torque of every joint along every run, from positions alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import savgol_filter

from .coordinates import coordinates
from .predictor import Predictor
from .replay import Replay
from .signature import Trace, force_trace
from .smoothing import odd

#: Over which the error of a position is fitted by a parabola [s]: its bend is the torque.
WIDTH = 0.15


@dataclass(frozen=True)
class TipTracer:
    """Makes the traces: balances ``joint_1``, ``joint_2`` ...

    Parameters
    ----------
    inertia : tuple of float
        Declared inertia of every joint [kg m^2].
    clutches : int
    position : str
        Signals of the joints' angles, numbered from 1.
    """

    inertia: tuple[float, ...]
    clutches: int
    position: str = "position"

    def __call__(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """What is missing as a torque: inertia times the bend of the position's error."""
        predicted = predictor.predict(values, replays)
        found: dict[str, list[Trace]] = {}
        for i, replay in enumerate(replays):
            told = {name: np.nan_to_num(series[i]) for name, series in predicted.items()}
            for j in range(len(self.inertia)):
                found.setdefault(f"joint_{j + 1}", []).append(self._trace(replay, told, j))
        return found

    def _trace(self, replay: Replay, told: Mapping[str, np.ndarray], j: int) -> Trace:
        step = float(np.median(np.diff(replay.time)))
        name = f"{self.position}_{j + 1}"
        error = replay.observed[name].values - told[name]
        missing = self.inertia[j] * bend(error, replay.observed[name].windows, step)
        others = {}
        for k in range(self.clutches):
            others[f"excitation_{k + 1}"] = told[f"excitation_{k + 1}"]
            others[f"slip_{k + 1}"] = np.sign(told[f"torque_{k + 1}"])
        friction = told[f"friction_{j + 1}"]
        total = sum(told[f"excitation_{k + 1}"] for k in range(self.clutches))
        along = coordinates(
            replay.time, replay.notes["position"][j], told[f"speed_{j + 1}"], friction,
            np.asarray(total), others,
        )  # fmt: skip
        return force_trace(missing, friction, along, step, 0.5 * WIDTH)


def bend(error: np.ndarray, windows: Sequence[int], step: float) -> np.ndarray:
    """Second derivative of an error by local parabolas, window by window."""
    found = np.zeros(error.size)
    for a, b in zip(windows, (*windows[1:], error.size), strict=True):
        if b - a > 8:
            width = odd(WIDTH / step, b - a)
            found[a:b] = savgol_filter(error[a:b], width, 2, deriv=2, delta=step, mode="interp")
    return found
