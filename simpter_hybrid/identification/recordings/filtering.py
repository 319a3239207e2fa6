"""Filters of a map: what they make of a channel, and of the noise of its sensor."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...problems import Problems
from .row_step import row_step
from .smoothing import GAP

if TYPE_CHECKING:  # a map has filters
    from .columns import Columns
    from .map_file import RecordingMap
    from .runs import RunSpan

#: So many samples for each order, or fewer, are not filtered: such a run is too short by itself.
FEWEST = 6
#: Frequencies at which the gain of white noise is summed up.
GRID = 4096


@dataclass(frozen=True)
class Filter:
    """Zero-phase Butterworth low-pass, as the thesis used (4.6): order and cutoff [Hz]."""

    order: int
    cutoff: float

    def apply(self, time: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Filtered forwards and backwards; evenly spaced samples are assumed between gaps.

        Across a gap nothing is known of the course: each stretch between two is filtered by itself.

        Parameters
        ----------
        time, values : ndarray (samples,)
            Stamps [s], and what is filtered.
        """
        step = row_step(time)
        if not step > 0.0:  # stamps that do not rise are refused elsewhere
            return values
        cuts = np.flatnonzero(np.diff(time) > GAP * step) + 1
        parts = [self._between_gaps(part, 1.0 / step) for part in np.split(values, cuts)]
        return parts[0] if len(parts) == 1 else np.concatenate(parts)

    def _between_gaps(self, values: np.ndarray, rate: float) -> np.ndarray:
        from scipy.signal import sosfiltfilt

        if values.size <= FEWEST * self.order or not self.cutoff < rate / 2:
            return values
        return sosfiltfilt(self._sections(rate), values)

    def gain(self, rate: float) -> float:
        """Deviation of filtered white noise over that of the noise; `rate` in samples a second."""
        from scipy.signal import sosfreqz

        if not self.cutoff < rate / 2:
            return 1.0
        _, response = sosfreqz(self._sections(rate), GRID)
        # Forwards and backwards: its power goes with the fourth power of the response.
        return float(np.sqrt(np.mean(np.abs(response) ** 4)))

    def _sections(self, rate: float) -> np.ndarray:
        from scipy.signal import butter

        return butter(self.order, self.cutoff, fs=rate, output="sos")


def rate_of(time: np.ndarray) -> float:
    """Samples a second."""
    return 1.0 / row_step(time)


def too_fast(
    runs: Sequence[RunSpan], columns: Columns, described: RecordingMap, problems: Problems
) -> None:
    """Cutoffs that samples as slow as these have not."""
    for signal, channel in described.channels.items():
        for run in runs if channel.filter is not None else ():
            time = described.stamps(columns.numbers, run.rows)
            step = row_step(time) if time.size > 1 else 0.0
            if channel.filter is not None and step > 0.0 and channel.filter.cutoff * step >= 0.5:
                what = "not below half the rate of the samples"
                right = f"less than {0.5 / step:.6g} Hz, or no filter ({run.name})"
                path = ("channels", signal, "filter", "cutoff")
                problems.add(path, what, f"{channel.filter.cutoff:g} Hz", right)
                break
