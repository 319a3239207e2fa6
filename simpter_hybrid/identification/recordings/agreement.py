"""Whether recorded speeds are the rates of the recorded positions: signs and units of a map."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from .map_file import ChannelMap

#: Movements over this long are compared [s]: longer than sensors lag.
SPAN = 0.1
#: Correlation from which on the factor between the two is that of the map's units or sign.  Over a
#: tenth of a second noise of a sensor that is worth its name leaves more than this.
SURE = 0.9
#: A sensor may be this factor wrong and still be one to be diagnosed.
FACTOR = 2.0


class Disagreement(NamedTuple):
    """A speed that is not the rate of its position."""

    signal: str
    what: str
    factor: float
    right: str


def disagreements(
    runs: Sequence[tuple[np.ndarray, Mapping[str, np.ndarray]]], channels: Mapping[str, ChannelMap]
) -> Iterator[Disagreement]:
    """Speeds that go against the positions recorded beside them, or at another scale.

    Parameters
    ----------
    runs : sequence of (ndarray (samples,), mapping of str to ndarray (samples,))
        Time stamps [s], and signal -> values [SI].
    channels : mapping of str to ChannelMap
    """
    for speed in channels:
        position = speed.replace("speed", "position", 1)
        if not speed.startswith("speed") or position not in channels:
            continue
        if "constant" in (channels[speed].role, channels[position].role):
            continue
        pairs = [
            _movements(time, found[position], found[speed])
            for time, found in runs
            if speed in found and position in found
        ]
        if not pairs:
            continue
        moved, expected = (np.concatenate(part) for part in zip(*pairs, strict=True))
        together, alone = float(moved @ expected), float(expected @ expected)
        if together**2 < SURE**2 * float(moved @ moved) * alone or together == 0.0:
            continue
        slope = together / alone
        what = f"{position} changes by this factor times the speed's integral"
        if slope < 0.0:
            yield Disagreement(speed, what, slope, "1: is the sign of one of them wrong?")
        elif not 1.0 / FACTOR < slope < FACTOR:
            yield Disagreement(speed, what, slope, "1: is the unit of one of them wrong?")


def _movements(
    time: np.ndarray, position: np.ndarray, speed: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Changes of a position over `SPAN`, and the speed's integral over the same samples."""
    known = np.isfinite(position) & np.isfinite(speed)
    time, position, speed = time[known], position[known], speed[known]
    if time.size < 2:
        return np.zeros(0), np.zeros(0)
    way = np.concatenate([[0.0], np.cumsum(0.5 * (speed[1:] + speed[:-1]) * np.diff(time))])
    every = max(1, round(SPAN / float(np.median(np.diff(time)))))
    return np.diff(position[::every]), np.diff(way[::every])
