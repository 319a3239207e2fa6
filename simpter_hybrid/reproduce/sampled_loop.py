"""The torque loop as a discrete-time system, apart from any simulation.

Between samples the command is held, so the excitation of a clutch with time constant T follows
``x+ = a x + (1 - a) v`` with ``a = exp(-Ts/T)`` exactly; the command is
``v = clip(v0 + gain (wanted - tau(x)))``. Linearized at its equilibrium that is one multiplier,
``a - (1 - a) gain tau'(x)``: the loop is stable while it stays above -1. The delay from off to on
passes once at the start; a dead time that is always there adds a state.
Slip speed is held constant (a heavy device), so that tau depends on the excitation alone.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from ..laws import LBF_IN, TestbedTorque


@dataclass(frozen=True)
class Loop:
    """A sampled torque loop around one slipping clutch.

    Parameters
    ----------
    gain : float
        [V/(lb-in)].
    rate : float
        [Hz].
    wanted : float
        Desired torque [lb-in].
    table_torque : float
        Torque at which the look-up table gives full scale [lb-in].
    time_constant, delay : float
        Of the clutch; the delay is from off to on only [s].
    dead_time : float
        From command to effect, always there, shorter than a sample period [s].
    speed : float
        Slip speed in (39) [rad/s].
    full_scale, threshold : float
        [V].
    """

    gain: float
    rate: float
    wanted: float = 150.0
    table_torque: float = 600.0
    time_constant: float = 0.07
    delay: float = 0.02
    dead_time: float = 0.0
    speed: float = 0.0
    full_scale: float = 10.0
    threshold: float = 0.05

    def torque(self, x: float) -> float:
        """Slip torque at an excitation, equation (39) [lb-in]."""
        law = TestbedTorque()
        factor = law.slope * self.speed + law.offset
        return factor * ((law.a * x + law.b) * x + law.c) / LBF_IN

    def slope(self, x: float) -> float:
        """Its derivative [lb-in/V]."""
        law = TestbedTorque()
        return (law.slope * self.speed + law.offset) * (2.0 * law.a * x + law.b) / LBF_IN

    def command(self, torque: float) -> float:
        """Command at a measured torque [V]."""
        table = self.wanted / self.table_torque * self.full_scale
        return min(max(table + self.gain * (self.wanted - torque), 0.0), self.full_scale)

    def equilibrium(self) -> float:
        """Excitation that its own torque commands [V]."""
        return brentq(lambda x: self.command(self.torque(x)) - x, 0.0, self.full_scale)

    def multiplier(self) -> float:
        """What a small deviation is multiplied by from sample to sample (the largest in size)."""
        gain = self.gain * self.slope(self.equilibrium())
        period, lag, dead = 1.0 / self.rate, self.time_constant, self.dead_time
        a = math.exp(-period / lag)
        if dead == 0.0:
            return a - (1.0 - a) * gain
        late = math.exp(-(period - dead) / lag)
        new, old = 1.0 - late, late - a
        roots = np.linalg.eigvals(np.array([[a - new * gain, old], [-gain, 0.0]]))
        return max(roots, key=abs)


def border(rate: float, **options: float) -> float:
    """Gain at which the loop loses its stability [V/(lb-in)]."""
    return brentq(lambda g: abs(Loop(g, rate, **options).multiplier()) - 1.0, 1e-4, 10.0)


def iterate(loop: Loop, samples: int) -> np.ndarray:
    """Excitation at every sample from the clutch off [V]: the nonlinear map with saturation."""
    period, lag = 1.0 / loop.rate, loop.time_constant
    x, found, closing = 0.0, [], None
    on = False
    for k in range(samples):
        found.append(x)
        v = loop.command(loop.torque(x) if on else 0.0)
        t, end = k * period, (k + 1) * period
        if not on:
            closing = (
                None if v <= loop.threshold else (t + loop.delay if closing is None else closing)
            )
            if closing is None or closing >= end:
                continue
            on, t, closing = True, closing, None
        x = v + (x - v) * math.exp(-(end - t) / lag)
        if v <= loop.threshold and x <= loop.threshold:
            on, x = False, 0.0
    return np.array(found)


@dataclass(frozen=True)
class Cycle:
    """A limit cycle: samples a period, frequency [Hz], and torque at its ends [lb-in]."""

    samples: int
    frequency: float
    low: float
    high: float


def limit_cycle(loop: Loop, settle: int = 4000) -> Cycle:
    """The cycle that the map ends in; one sample a period is a steady state.

    Between samples the excitation is monotonic, so the extremes are at samples.

    Raises
    ------
    ValueError
        If no cycle of at most 64 samples is found.
    """
    tail = iterate(loop, settle)[-128:]
    for n in range(1, 65):
        if np.allclose(tail[n:], tail[:-n], rtol=0.0, atol=1e-9):
            torque = [loop.torque(x) for x in tail[:n]]
            return Cycle(n, loop.rate / n if n > 1 else 0.0, min(torque), max(torque))
    raise ValueError(
        f"no cycle of at most 64 samples after {settle} samples at gain {loop.gain} V/(lb-in) and "
        f"{loop.rate} Hz; the loop may be chaotic or settle slowly: raise `settle`"
    )
