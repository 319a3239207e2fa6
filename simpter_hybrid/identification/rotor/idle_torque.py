"""What the sensor of a clutch's torque shows while nothing commands the clutch: its zero."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..recordings.recorded_run import RecordedRun
from ..recordings.row_step import row_step
from .signals import RotorSignals

#: Rows of a run of which a mean is taken; of fewer it is noise.
LEAST = 50


def idle_torque(runs: Sequence[RecordedRun], signals: RotorSignals, settles: float) -> float:
    """Median over runs of what is shown where the clutch has been off for `settles` [SI].

    0 where no run shows it.  The median of a drag that is there too is some of it: what is compared
    with this has to be beyond noise without it as well.

    Parameters
    ----------
    runs : sequence of RecordedRun
    signals : RotorSignals
    settles : float
        Time after which what was commanded before is forgotten [s].
    """
    told = [
        float(np.mean(run.channels[signals.transmitted][idle]))
        for run in runs
        if (idle := _idle(run, signals, settles)).sum() >= LEAST
    ]
    return float(np.median(told)) if told else 0.0


def _idle(run: RecordedRun, signals: RotorSignals, settles: float) -> np.ndarray:
    """Samples behind rows of no command that last for `settles` (samples,)."""
    rows = round(settles / row_step(run.time))
    acts = run.channels[signals.command] != 0.0
    # Nobody knows what was commanded before the first row.
    last = np.maximum.accumulate(np.where(acts, np.arange(acts.size), -1))
    return np.arange(acts.size) - last > rows
