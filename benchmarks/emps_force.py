"""The force error of EMPS as its authors measure it: an inverse model on the filtered motion.

Positions are filtered (Butterworth of 4th order, 100 Hz, both ways) and differenced twice; what
force the model needs for that motion, and the motor's, are decimated by ten after the first 49 rows
are left out; the error is the norm of their difference over that of the motor's force (A. Janot, M.
Gautier, M. Brunot 2019, and their script).  Ends are filtered, and rows picked, as Matlab does it:
so the published parameters leave what was published.
"""

from __future__ import annotations

import numpy as np
from scipy.signal import butter, cheby1, filtfilt

from simpter_hybrid.identification.axis.prescribed_replays import CLEARER
from simpter_hybrid.identification.axis.prescribed_rig import PrescribedRig
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.recordings.recording import RecordedRun
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.scenario import Scenario

#: Of the motor, as published [N/V].
GAIN = 35.15065188248547
ORDER, CUTOFF, BORDER, EVERY = 4, 100.0, 49, 10
#: Rows of a piece: a run is set anew at every row, which may be 20,000 times at the most.
PIECE = 10_000


def moved(run: RecordedRun) -> list[Replay]:
    """A run as motions from outside, by the authors' filter, in pieces."""
    step = float(np.median(np.diff(run.time)))
    position = as_matlab(butter(ORDER, CUTOFF * 2.0 * step), ORDER, run.channels["position"])
    speed = np.gradient(position, step)
    notes = {
        "position": position, "speed": speed, "acceleration": np.gradient(speed, step),
        CLEARER: np.zeros(position.size),
    }  # fmt: skip
    pieces = []
    for k in range(BORDER, position.size, PIECE):
        cut = slice(k, min(k + PIECE, position.size))
        time = run.time[cut] - run.time[k]
        seen = Observation(GAIN * run.channels["drive"][cut], 1.0, np.ones(time.size, bool))
        name, inputs = f"{run.name} from row {k}", {"press": np.zeros(time.size)}
        its = {signal: values[cut] for signal, values in notes.items()}
        pieces.append(
            Replay(
                name, run.experiment, time, inputs, {"force": seen}, drive_is_exact=False, notes=its
            )
        )
    return pieces


def as_matlab(made: tuple, order: int, values: np.ndarray) -> np.ndarray:
    """Both ways, with as many rows beyond the ends as Matlab takes."""
    return filtfilt(*made, values, padlen=3 * order)


def decimated(values: np.ndarray) -> np.ndarray:
    """Every tenth row up to the last, after a low-pass."""
    order = 8
    smooth = as_matlab(cheby1(order, 0.05, 0.8 / EVERY), order, values)
    return smooth[(values.size - 1) % EVERY :: EVERY]


def relative_error(scenario: Scenario, run: RecordedRun) -> float:
    """Of the force that the scenario needs for a run's motion [%]."""
    pieces = moved(run)
    predictor = ScenarioPredictor(scenario, PrescribedRig())
    values = {p.name: p.value for p in predictor.parameters}
    needed = np.concatenate(predictor.predict(values, pieces)["force"])
    given = np.concatenate([piece.observed["force"].values for piece in pieces])
    left = np.linalg.norm(decimated(given - needed))
    return 100.0 * float(left / np.linalg.norm(decimated(given)))
