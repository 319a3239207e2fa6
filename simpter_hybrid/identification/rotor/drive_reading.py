"""Whether the torque that was logged is the torque that was asked for, where that drove."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..recordings.checks import Finding
from ..recordings.recording import Recording
from .signals import RotorSignals

#: A reading that is this part off the torque that was asked for is worth a question, ...
GAIN = 0.01
#: ... if chance does as much in one of ten thousand recordings, to either side.
SURE = 0.9999
#: Rows tell where the torque that was asked for goes on by less than this part of its largest.
STEADY = 0.01
#: A run tells a gain by so many rows, if white noise moves it by less than this part of `GAIN`; so
#: many such runs tell how sure their mean is, whatever the noise.
FEWEST, TOLD, RUNS = 100, 0.2, 3


def drive_remarks(recording: Recording, signals: RotorSignals) -> Iterator[Finding]:
    """A remark on a logged drive that is off its own reference, which no friction explains.

    Parameters
    ----------
    recording : Recording
    signals : RotorSignals
        What is logged as `applied`, and asked for as `prescribed` in runs driven by a torque.
    """
    from scipy.stats import t as student

    gains = []
    for run in recording.runs:
        told = run.channels
        if {signals.applied, signals.prescribed, "servo_mode"} <= set(told):
            gains += _gain(told[signals.prescribed], told[signals.applied], told["servo_mode"])
    if len(gains) < RUNS:
        return
    gain, error = float(np.mean(gains)), float(np.std(gains, ddof=1)) / np.sqrt(len(gains))
    if abs(gain - 1.0) <= max(GAIN, error * float(student.ppf(0.5 + 0.5 * SURE, len(gains) - 1))):
        return
    what = f"{signals.applied} reads another torque than was asked for ({signals.prescribed})"
    right = f"the same; is the gain or unit of {signals.applied}, or what gives the torque, right?"
    width = error * float(student.ppf(0.975, len(gains) - 1))
    value = f"{gain:.4g} times it, ± {width:.2g} (95 %)"
    yield Finding.of_all(what, value, right)


def _gain(asked: np.ndarray, seen: np.ndarray, mode: np.ndarray) -> list[float]:
    """What one run tells of the gain, beside a zero that is off; empty where it tells little."""
    # A row shows what was asked for at the one before it; where that jumps it may show either.
    steady = np.abs(np.diff(asked)) <= STEADY * np.max(np.abs(asked), initial=0.0)
    rows = steady & (mode[1:] > 0.5) & np.isfinite(seen[1:])
    given, shown = asked[:-1][rows], seen[1:][rows]
    moved = given - np.mean(given) if given.size else given
    square = float(moved @ moved)
    if given.size < FEWEST or square == 0.0:
        return []
    gain = float(moved @ shown) / square
    left = shown - np.mean(shown) - gain * moved
    return [gain] if np.std(left) <= TOLD * GAIN * np.sqrt(square) else []
