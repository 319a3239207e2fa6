"""Residual force of one axis along every run, by inverse dynamics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import cumulative_trapezoid

from ..fitting.predictor import Predictor
from ..fitting.replay import Replay
from ..recordings.smoothing import derivative, speed_width
from ..tracing.coordinates import coordinates
from ..tracing.trace import PLACE, Trace, force_trace

#: Kernel through which the error of the speed passes to be one of acceleration [s].
WIDTH = 0.06
#: The record's acceleration is taken over so many times it: of noise that leaves a 64th.
WIDER = 4


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
        # Not a servo's own loop: set anew it would have lost what its integral holds.
        replays = [
            r if r.inputs["drive"].any() else replace(r, restarts=r.restarts or r.followed)
            for r in replays
        ]
        predicted = predictor.predict(values, replays)
        found = []
        for i, replay in enumerate(replays):
            step = float(np.median(np.diff(replay.time)))
            width = max(WIDTH, 9 * step)
            rises = predicted["acceleration"][i] * step
            told = unbroken(predicted["speed"][i], rises, [r.index for r in replay.restarts])
            if "speed" not in replay.observed:  # then the record's was derived from positions
                course = cumulative_trapezoid(told, dx=step, initial=0.0)
                told = derivative(course, step, speed_width(step))
            missing = self.inertia * derivative(replay.notes["speed"] - told, step, width)
            # Not the predicted one: it holds the force's noise and, where a servo makes up for what
            # is missing, that too.  The record's noise is in what is missing as well, but for this
            # kernel.
            recorded = derivative(replay.notes["speed"], step, WIDER * width)
            others = {"acceleration": recorded}
            along = coordinates(
                replay.time,
                replay.notes["position"],
                replay.notes["speed"],
                replay.inputs["drive"],
                np.nan_to_num(predicted["excitation"][i]),
                others,
                turn=self.turn,
            )
            if not np.ptp(replay.inputs["press"]) > 0.0:  # then friction has no excitation
                along = {n: x for n, x in along.items() if not n.startswith("excitation")}
            drive, logged = replay.inputs["drive"], replay.logged
            found.append(force_trace(missing, drive, along, step, logged=logged, local=PLACE))
        return {"force": found}


def unbroken(speed: np.ndarray, rises: np.ndarray, set_anew: Sequence[int]) -> np.ndarray:
    """A predicted speed (samples,) without the jumps where it was set from the record.

    There `rises`, what it rises in each sample by its own acceleration, stand for the jump.
    """
    steps = np.diff(np.nan_to_num(speed), prepend=0.0)
    for k in set_anew:
        steps[k : k + 2] = np.nan_to_num(rises[k : k + 2])
    return np.cumsum(steps)
