"""Noise of a channel, estimated where the map does not state it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .recording_map import ChannelMap

if TYPE_CHECKING:  # recordings ask for noise themselves, when they are read
    from .recording import Recording


def noise_estimate(values: np.ndarray, step: float | None = None) -> float:
    """Standard deviation of white noise on a smooth signal (quantisation included).

    From third differences, which leave nothing of a parabola; their median is not moved by the
    few samples at jumps. Coloured noise is underestimated: use replicates where there are any.

    Parameters
    ----------
    values : ndarray (samples,)
    step : float, optional
        Quantisation; the estimate is at least that of rounding, step / sqrt(12).
    """
    third = np.abs(np.diff(values[np.isfinite(values)], 3))
    # The third difference of white noise has variance 1 + 9 + 9 + 1 = 20.
    sd = float(np.median(third)) / 0.6744897501960817 / np.sqrt(20.0) if third.size else 0.0
    return max(sd, (step or 0.0) / np.sqrt(12.0), 1e-12)


def stated_noise(channel: ChannelMap) -> float | None:
    """The noise that a map states for a channel, with its quantisation [SI]."""
    if channel.noise is None:
        return None
    return float(np.hypot(channel.noise, (channel.step or 0.0) / np.sqrt(12.0)))


def run_noise(values: np.ndarray, channel: ChannelMap) -> float:
    """Noise of one run of a channel, as stated or else estimated [SI]."""
    stated = stated_noise(channel)
    return noise_estimate(values, channel.step) if stated is None else stated


def channel_noise(recording: Recording, name: str) -> float:
    """Noise of a channel as stated, or else the median of its runs' estimates [SI]."""
    channel = recording.channels[name]
    stated = stated_noise(channel)
    if stated is not None:
        return stated
    logged = [r.channels[name] for r in recording.runs if name in r.channels]
    return float(np.median([noise_estimate(values, channel.step) for values in logged]))
