"""Whether the torque that was logged is the torque that was asked for, where that drove."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..recordings.checks import Finding
from ..recordings.recording import Recording
from .signals import RotorSignals

#: A reading that is this part off the torque that was asked for is worth a question, ...
GAIN = 0.01
#: ... if it is so many of its standard errors.
SURE = 5.0
#: Rows tell where the torque that was asked for goes on by less than this part of its largest.
STEADY = 0.01
#: Fewer rows tell nothing.
FEWEST = 100


def drive_remarks(recording: Recording, signals: RotorSignals) -> Iterator[Finding]:
    """A remark on a logged drive that is off its own reference, which no friction explains.

    Parameters
    ----------
    recording : Recording
    signals : RotorSignals
        What is logged as `applied`, and asked for as `prescribed` in runs driven by a torque.
    """
    asked, seen = [], []
    for run in recording.runs:
        told = run.channels
        if not {signals.applied, signals.prescribed, "servo_mode"} <= set(told):
            continue
        # A row has what was asked for at the one before it, and both where that goes on evenly.
        reference = told[signals.prescribed]
        rises = np.abs(np.diff(reference))
        steady = rises <= STEADY * np.max(np.abs(reference), initial=0.0)
        rows = steady & (told["servo_mode"][1:] > 0.5) & np.isfinite(told[signals.applied][1:])
        asked.append(reference[1:][rows])
        seen.append(told[signals.applied][1:][rows])
    given, shown = (np.concatenate(x) if x else np.zeros(0) for x in (asked, seen))
    square = float(given @ given)
    if given.size < FEWEST or square == 0.0:
        return
    gain = float(given @ shown) / square
    error = float(np.std(shown - gain * given)) / np.sqrt(square)
    if abs(gain - 1.0) <= max(GAIN, SURE * error):
        return
    what = f"where a torque drives, {signals.applied} reads another one than {signals.prescribed}"
    right = f"the same; is the gain or unit of {signals.applied}, or what gives the torque, right?"
    value = f"{gain:.4g} times it, ± {2.0 * error:.2g}"
    yield Finding("all runs", what, value, right, -1, float("nan"))
