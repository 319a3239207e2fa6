"""Residual force of one axis along every run, by inverse dynamics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .coordinates import coordinates
from .predictor import Predictor
from .replay import Replay
from .signature import Trace, force_trace
from .smoothing import derivative, hann_smoothed

#: Kernel through which measured and predicted accelerations pass [s].
WIDTH = 0.06


@dataclass(frozen=True)
class AxisTracer:
    """Makes the traces of a driven axis: the one balance ``force``.

    Parameters
    ----------
    inertia : float
        Declared [kg m^2 or kg].
    turn : float
        Period of the position [rad]; inf for a straight axis.
    """

    inertia: float
    turn: float = np.inf

    def __call__(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """What is missing as a force: inertia times the error of the acceleration."""
        predicted = predictor.predict(values, replays)
        found = []
        for i, replay in enumerate(replays):
            step = float(np.median(np.diff(replay.time)))
            width = max(WIDTH, 9 * step)
            measured = derivative(replay.notes["speed"], step, width)
            told = hann_smoothed(np.nan_to_num(predicted["acceleration"][i]), step, width)
            missing = self.inertia * (measured - told)
            along = coordinates(
                replay.time,
                replay.notes["position"],
                replay.notes["speed"],
                replay.inputs["drive"],
                np.nan_to_num(predicted["excitation"][i]),
                turn=self.turn,
            )
            found.append(force_trace(missing, replay.inputs["drive"], along, step))
        return {"force": found}
