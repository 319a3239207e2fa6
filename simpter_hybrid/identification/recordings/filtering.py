"""Filters of a map: what they make of a channel, and of the noise of its sensor."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...problems import Problems
from .row_step import gaps, row_step

if TYPE_CHECKING:  # a map has filters
    from .columns import Columns
    from .map_file import RecordingMap
    from .runs import RunSpan

#: So many samples for each order, or fewer, are not filtered: such a run is too short by itself.
FEWEST = 6
#: A filter that reaches less than this part of the rows between gaps is none.
REACHES = 0.5
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
        stretches = np.split(values, gaps(time) + 1)
        parts = [self._between_gaps(part, 1.0 / step) for part in stretches]
        return parts[0] if len(parts) == 1 else np.concatenate(parts)

    def reach(self, time: np.ndarray) -> float:
        """Part of the rows that are filtered: those of stretches that are not too short for it."""
        sizes = np.diff([0, *(gaps(time) + 1), time.size])
        return float(sizes[sizes > FEWEST * self.order].sum()) / time.size

    def left(self, time: np.ndarray) -> float:
        """Deviation of white noise once this was applied, over that of the noise (all rows)."""
        part, gain = self.reach(time), self.gain(rate_of(time))
        return gain if part == 1.0 else float(np.sqrt(part * gain**2 + 1.0 - part))

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
    """Cutoffs that samples as slow as these have not, and filters that gaps leave nothing to do."""
    for signal, channel in described.channels.items():
        for run in runs if channel.filter is not None else ():
            time = described.stamps(columns.numbers, run.rows)
            step = row_step(time) if time.size > 1 else 0.0
            if channel.filter is None or not step > 0.0:
                continue
            if channel.filter.cutoff * step >= 0.5:
                what = "not below half the rate of the samples"
                right = f"less than {0.5 / step:.6g} Hz, or no filter ({run.name})"
                path = ("channels", signal, "filter", "cutoff")
                problems.add(path, what, f"{channel.filter.cutoff:g} Hz", right)
                break
            reach = channel.filter.reach(time)
            if gaps(time).size and reach < REACHES:
                what = "filters hardly anything: stretches between gaps are too short for it"
                most = FEWEST * channel.filter.order
                right = f"stretches of more than {most} rows, a lower order, or no filter"
                got = f"{100 * reach:.0f} % of the rows of {run.name}"
                problems.add(("channels", signal, "filter"), what, got, right)
                break
