"""A speed that shows rest in no run in which breakaways are looked for: then none is compared."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from scipy.ndimage import maximum_filter1d

from ..recordings.checks import Finding
from ..recordings.recorded_run import RecordedRun
from ..recordings.recording import Recording
from ..recordings.smoothing import moving_mean
from .conditioning import MEAN, RESTS_BELOW, RESTS_FOR
from .signals import RotorSignals


def never_rests(
    recording: Recording, signals: RotorSignals, sd: Mapping[str, float]
) -> Iterator[Finding]:
    """A remark where no run that a torque drives, with the clutch on, shows the rotor at rest.

    Parameters
    ----------
    recording : Recording
    signals : RotorSignals
    sd : mapping of str to float
        Noise of its channels [SI].
    """
    asked = [run for run in recording.runs if _looked_for(run, signals)]
    if not asked or any(_rests(run.channels[signals.speed], sd[signals.speed]) for run in asked):
        return
    what = (
        f"{signals.speed} shows rest in no run that a torque drives with the clutch on: no "
        "breakaway is compared"
    )
    right = f"rest before it breaks away; is the zero of {signals.speed}, or its noise, right?"
    yield Finding.of_all(what, f"{len(asked)} run{'s' if len(asked) > 1 else ''}", right)


def _looked_for(run: RecordedRun, signals: RotorSignals) -> bool:
    by_torque = np.isfinite(run.channels[signals.prescribed]).all()
    return bool(by_torque and run.channels[signals.command].any())


def _rests(speed: np.ndarray, noise: float) -> bool:
    """Whether it is at rest for as long as makes a stop."""
    mean = np.abs(moving_mean(speed, MEAN))
    longest = maximum_filter1d(mean, RESTS_FOR, mode="constant", cval=np.inf)
    return bool((longest < RESTS_BELOW * noise / np.sqrt(MEAN)).any())
