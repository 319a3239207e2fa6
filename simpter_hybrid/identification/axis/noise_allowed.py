"""What noise of an axis's drive and starts may do, and up to how many times the floor is noise."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..fitting.replay import Replay
from ..recordings.noise import coarse_step, driven_step
from ..recordings.recording import Recording
from ..recordings.row_step import row_step
from ..recordings.smoothing import FITTED, speed_width
from ..rigs.input_noise import InputNoise
from ..rigs.scenario_predictor import ScenarioPredictor
from ..tracing.limits import COARSE_AXIS, ROUNDED_AXIS, SIMULATED_AXIS, SINGLE_AXIS, Limits
from .driven import Driven
from .signals import AxisSignals

#: How often the noise of inputs is added anew to learn what it does.  White noise of a current
#: moves half a second of positions in a dozen shapes that stand above an encoder's noise: by 12
#: draws of it a null was left at 1.57 times its floor, by 24 at 1.05, by these at 0.96.
DRAWS = 48
#: The same number for runs behind a servo, whose loop makes the noise, and for runs let alone,
#: which have only that of their start (none, where it is fitted) or of what presses.
DRAWS_WHOLE = 12
#: A step of less than this part of a drive's range is one of the digits that were written.
FINE = 1e-4


def input_noise(
    recording: Recording, driven: Driven, signals: AxisSignals, predictor: ScenarioPredictor,
    made: Callable[[Recording], list[Replay]],
) -> InputNoise | None:  # fmt: skip
    """What noise does to predictions, where it is simulated.

    Parameters
    ----------
    recording : Recording
    driven : Driven
    signals : AxisSignals
    predictor : ScenarioPredictor
    made : callable (recording) -> list of Replay
        All replays of a recording.

    Returns
    -------
    InputNoise or None
        None for a driver that was told what to do where a speed was measured.
    """
    if driven.told and signals.speed in recording.channels:
        return None
    told, seen = frozenset(signals.told), signals.sensed | {signals.reference}
    draws = DRAWS_WHOLE if driven.alone or driven.servo else DRAWS
    return InputNoise(predictor, recording, made, told, seen, draws)


def limits_of(
    searched: Recording, driven: Driven, signals: AxisSignals, simulated: bool,
    fitted: Sequence[Replay],
) -> Limits:  # fmt: skip
    """Up to how many times the floor an error is taken for noise.

    `simulated`: whether what the noise of inputs does to predictions is simulated.
    """
    limits = SINGLE_AXIS
    if simulated:
        step = max(row_step(run.time) for run in fitted)
        # Over a whole run a start that is a little wrong is one of its curves.
        windows = not (signals.speed in searched.channels or driven.alone)
        limits = COARSE_AXIS if windows and speed_width(step) > FITTED else SIMULATED_AXIS
        limits = ROUNDED_AXIS if rounded(searched, signals) else limits
        limits = limits._replace(drive=driven.sensed, rounds=_rounds(searched, signals))
    return limits._replace(told=driven.told)


def _rounds(recording: Recording, signals: AxisSignals) -> bool:
    """Whether an encoder shows the motion so coarsely that noise does not carry it across."""
    if signals.speed in recording.channels:
        return False
    seen = (r.channels[signals.position] for r in recording.runs if signals.position in r.channels)
    return any(coarse_step(position) for position in seen)


def rounded(recording: Recording, signals: AxisSignals) -> bool:
    """Whether the sensor of the drive rounds so coarsely that noise does not carry it across."""
    names = signals.sensed & recording.channels.keys()
    known = [n for n in names if recording.channels[n].noise is None]
    logged = (run.channels[n] for n in known for run in recording.runs)
    return any((driven_step(drive) or 0.0) > FINE * float(np.ptp(drive)) for drive in logged)
