"""A chain of masses of any length with any number of clutches, for cost against size."""

from __future__ import annotations

import math
from dataclasses import dataclass

from simpter_hybrid.applied_load import Load
from simpter_hybrid.clutch import Clutch, TorqueLaw
from simpter_hybrid.controller import Controller
from simpter_hybrid.device import Device
from simpter_hybrid.scenario import Scenario


@dataclass(frozen=True)
class Chain(Device):
    """Pendulums on one axis, joined by springs; clutch i against the frame, then between
    neighbours."""

    count: float = 2.0
    clutches: float = 2.0

    @staticmethod
    def mass_matrix(q, p, out):
        n = int(p[0])
        for i in range(n * n):
            out[i] = 0.0
        for i in range(n):
            out[i * n + i] = 1.0 + 0.1 * i

    @staticmethod
    def velocity_terms(q, qd, p, out):
        n = int(p[0])
        for i in range(n):
            out[i] = 4.0 * math.sin(q[i])
            if i > 0:
                out[i] += 20.0 * (q[i] - q[i - 1])
            if i < n - 1:
                out[i] += 20.0 * (q[i] - q[i + 1])

    @staticmethod
    def clutch_map(q, p, out):
        n = int(p[0])
        for i in range(n * int(p[1])):
            out[i] = 0.0
        for i in range(int(p[1])):
            out[i * n + i % n] = 1.0
            if i >= n and n > 1:
                out[i * n + (i + 1) % n] = -1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        for i in range(int(p[1])):
            out[i] = 0.0


@dataclass(frozen=True)
class Push(Load):
    """Two sinusoids on every coordinate; ``tempo`` hurries them."""

    size: float = 6.0
    tempo: float = 1.0

    @staticmethod
    def force(time, n, size, tempo, Q):
        now = tempo * time
        for j in range(n):
            Q[j] += size * math.sin((2.1 + 0.7 * j) * now) + 0.4 * size * math.sin(5.3 * now + j)


@dataclass(frozen=True)
class Wandering(Controller):
    """Commands that change at every sample, some of them off."""

    rate: float = 30.0

    @staticmethod
    def step(k, m, rate, held):
        for i in range(m):
            held[i] = max(0.0, 2.0 + 3.0 * math.sin(0.9 * k / rate * 6.28 + 1.7 * i))


@dataclass(frozen=True)
class Linear(TorqueLaw):
    """Torque in proportion to the excitation; breakaway one fifth above."""

    gain: float = 1.0

    @staticmethod
    def slip_torque(excitation, speed, gain):
        return gain * excitation * (1.0 + 0.05 * speed)

    @staticmethod
    def break_torque(excitation, gain):
        return 1.2 * gain * excitation


def chain(n: int, m: int, rate: float, t_end: float = 3.0, tempo: float = 1.0) -> Scenario:
    """``n`` coordinates, ``m`` clutches, sampled at ``rate`` [Hz] (0: constant commands).

    ``tempo``: of the load, and with it of the events; the load grows with it.
    """
    kind = type(
        "Chain", (Chain,),
        {
            "coordinates": tuple(f"q{j}" for j in range(n)),
            "surfaces": tuple(f"c{i}" for i in range(m)),
        },
    )  # fmt: skip
    run = Scenario(
        f"chain {n} {m}", kind(float(n), float(m)), (Clutch(Linear()),) * m, (0.3,) * n,
        (0.0,) * n, t_end, loads=(Push(6.0 * tempo, tempo),), command=(2.0,) * m,
        excitation=(2.0,) * m,
    )  # fmt: skip
    if rate == 0.0:
        return run
    return run.replace(controllers=((Wandering(rate), 1),), period=1.0 / rate)
