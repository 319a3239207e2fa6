"""A sensor: what an instrument makes of a signal, for outputs and comparisons with recordings."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .noise import gaussian, quantised
from .part import Part, parameter

#: A mean over the past is one of the signal at so many instants in it.
PARTS = 16


@dataclass(frozen=True)
class Sensor(Part):
    """Gain, offset, delay, average, filter, noise, quantisation and clock of one channel.

    A reading at the sensor's instant t is taken from the true signal at ``(1 + clock_rate) t +
    clock_shift - delay``, averaged, filtered, scaled, shifted, noisy, and rounded, in this order.

    Parameters
    ----------
    gain : float
        Relative excess.
    offset : float
        In the channel's SI unit.
    noise : float
        Standard deviation, in the channel's SI unit.
    step : float
        Quantisation, in the channel's SI unit; 0: none.
    delay : float
        [s].
    average : float
        Of so long a time before each reading the mean is shown, as by counts [s].
    filter : float
        Time constant of a first-order filter [s]; 0: none.
    clock_shift : float
        [s].
    clock_rate : float
        Relative excess of the clock's period.
    seed : int
        Of the noise.
    """

    gain: float = parameter("dimensionless", 0.0, typical=0.02)
    offset: float = parameter("dimensionless", 0.0)
    noise: float = parameter("dimensionless", 0.0, low=0.0)
    step: float = parameter("dimensionless", 0.0, low=0.0)
    delay: float = parameter("time", 0.0, low=0.0, typical=0.005)
    average: float = parameter("time", 0.0, low=0.0, typical=0.01)
    filter: float = parameter("time", 0.0, low=0.0, typical=0.005)
    clock_shift: float = parameter("time", 0.0, typical=0.005)
    clock_rate: float = parameter("dimensionless", 0.0, typical=1e-3)
    seed: int = 0

    def read(
        self,
        times: np.ndarray,
        signal: Callable[[np.ndarray], np.ndarray],
        channel: int = 0,
        first: int = 0,
    ) -> np.ndarray:
        """Readings at ``times``.

        Parameters
        ----------
        times : array, (N,)
            Sample instants by the sensor's clock [s], evenly spaced if there is a filter.
        signal : callable
            The true signal at given instants; asked within and a little before the run, where it
            should answer with its first value.
        channel : int
            Number of the channel: channels have noise of their own.
        first : int
            Number of the first sample; noise belongs to the number, not to the call.

        Returns
        -------
        array, (N,)
        """
        times = np.asarray(times, dtype=float)
        values = self._filtered(times, signal)
        values = (1.0 + self.gain) * values + self.offset
        if self.noise > 0.0:
            drawn = [gaussian(self.seed, channel, first + k) for k in range(len(times))]
            values = values + self.noise * np.array(drawn)
        return np.array([quantised(v, self.step) for v in values])

    def _filtered(self, times: np.ndarray, signal: Callable) -> np.ndarray:
        """The filter's exact response to the signal made of straight pieces, eight a sample."""

        def seen(t: np.ndarray) -> np.ndarray:
            true = (1.0 + self.clock_rate) * t + self.clock_shift - self.delay
            if self.average <= 0.0:
                return np.asarray(signal(true), dtype=float)
            middles = self.average * (np.arange(PARTS) + 0.5) / PARTS
            seen = signal((true[:, None] - middles).ravel())
            return np.asarray(seen, dtype=float).reshape(true.size, PARTS).mean(axis=1)

        if self.filter <= 0.0 or len(times) == 0:
            return seen(times)
        parts = 8
        between = np.linspace(times[:-1], times[1:], parts, endpoint=False).T.ravel()
        fine = np.append(between, times[-1])
        x = seen(fine)
        out = np.empty_like(x)
        out[0] = x[0]
        for k in range(1, len(x)):
            h = (fine[k] - fine[k - 1]) / self.filter
            slope = (x[k] - x[k - 1]) / h
            out[k] = x[k] - slope + (out[k - 1] - x[k - 1] + slope) * math.exp(-h)
        return out[::parts]


def differentiated(times: np.ndarray, values: np.ndarray, filter: float = 0.0) -> np.ndarray:
    """Speed from positions by backward differences, through a first-order filter [s] if asked.

    What a controller makes of a potentiometer: noise over the sampling interval, and half an
    interval of delay.

    Parameters
    ----------
    times : ndarray (N,)
        Instants [s].
    values : ndarray (N,)
        Positions at them [rad or m].
    filter : float
        Time constant [s]; 0: none.

    Returns
    -------
    ndarray (N,)
        [rad/s or m/s]; 0 at the first instant, before which nothing is known.
    """
    if len(times) < 2:
        return np.zeros(len(times))
    rates = np.diff(values, prepend=values[:1]) / np.diff(times, prepend=2 * times[0] - times[1])
    if filter <= 0.0:
        return rates
    out = np.empty_like(rates)
    out[0] = rates[0]
    for k in range(1, len(rates)):
        share = 1.0 - math.exp(-(times[k] - times[k - 1]) / filter)
        out[k] = out[k - 1] + share * (rates[k] - out[k - 1])
    return out
