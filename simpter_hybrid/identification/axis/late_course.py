"""A model's speed between its rows, as a sensor that is late sees it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate

import numpy as np


@dataclass(frozen=True)
class Course:
    """Speeds from time 0 on: between rows parabolas with the acceleration at their ends.

    Parameters
    ----------
    time, speed, acceleration : ndarray (rows,)
        [s; rad/s or m/s; and that per second]
    rate : float
        At which the speed had changed before time 0.
    """

    time: np.ndarray
    speed: np.ndarray
    acceleration: np.ndarray
    rate: float

    @cached_property
    def pieces(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Of each interval its length, the slope at its beginning, and half of the curvature."""
        step, end = np.diff(self.time), self.acceleration[1:]
        slope = np.diff(self.speed) / step
        return step, 2.0 * slope - end, (end - slope) / step

    @cached_property
    def ways(self) -> np.ndarray:
        """Ways gone up to each row (rows,)."""
        step, slope, half = self.pieces
        each = step * (self.speed[:-1] + step * (slope / 2.0 + step * half / 3.0))
        return np.concatenate([[0.0], np.cumsum(each)])

    def at(self, time: np.ndarray) -> np.ndarray:
        """Speed at some instants up to the last row."""
        since, v, b, c, _ = self._of(time)
        return v + since * (b + since * c)

    def way(self, time: np.ndarray) -> np.ndarray:
        """Way gone from time 0 on up to some instants."""
        since, v, b, c, gone = self._of(time)
        return gone + since * (v + since * (b / 2.0 + since * c / 3.0))

    def _of(self, time: np.ndarray) -> tuple[np.ndarray, ...]:
        """Time since the row before, and there the speed, slope, half curvature and way."""
        _, slope, half = self.pieces
        k = np.searchsorted(self.time, time, side="right") - 1
        before, k = k < 0, np.clip(k, 0, max(0, slope.size - 1))
        b, c = (x[k] if x.size else np.zeros(k.size) for x in (slope, half))
        return (
            time - self.time[k], self.speed[k], np.where(before, self.rate, b),
            np.where(before, 0.0, c), self.ways[k],
        )  # fmt: skip

    def lagged(self, lag: float) -> np.ndarray:
        """Speeds behind a first-order lag: its exact response (rows,)."""
        step, slope, half = self.pieces
        bent = 2.0 * lag**2 * half
        first = self.speed[:-1] - lag * slope + bent
        last = self.speed[1:] - lag * self.acceleration[1:] + bent
        fade = np.exp(-step / lag)
        pairs = zip(fade.tolist(), (last - fade * first).tolist(), strict=True)
        begun = float(self.speed[0] - lag * self.rate)
        return np.array([*accumulate(pairs, lambda y, of: of[0] * y + of[1], initial=begun)])
