"""Random runs of PTER: constant commands, random commands held by samples, controllers."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass

from simpter_hybrid.applied_load import Load
from simpter_hybrid.clutch import Clutch, TorqueLaw
from simpter_hybrid.controller import Controller
from simpter_hybrid.controllers.impedance import ImpedanceToLine
from simpter_hybrid.controllers.lookup import LookupTable
from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.laws import LBF_IN
from simpter_hybrid.scenario import Scenario

KINDS = ("constant", "30 Hz", "150 Hz", "controller 30 Hz", "controller 150 Hz")


@dataclass(frozen=True)
class Quadratic(TorqueLaw):
    """``slip = (slope speed + 1)(a v^2 + b v + c)``; ``break = gap (a v^2 + b v + c)``."""

    slope: float
    a: float
    b: float
    c: float
    gap: float

    @staticmethod
    def slip_torque(speed, excitation, slope, a, b, c):
        return (slope * speed + 1.0) * ((a * excitation + b) * excitation + c)

    @staticmethod
    def break_torque(excitation, a, b, c, gap):
        return gap * ((a * excitation + b) * excitation + c)


@dataclass(frozen=True)
class Sines(Load):
    """Force on each coordinate: an offset and sinusoids (coordinate, size, rad/s, phase)."""

    first: float
    second: float
    lines: tuple[tuple[float, float, float, float], ...]

    def table(self) -> tuple[float, ...]:
        return (float(len(self.lines)), *(v for line in self.lines for v in line))

    @staticmethod
    def force(time, p, table_at, first, second, Q):
        Q[0] += first
        Q[1] += second
        for k in range(int(p[table_at])):
            at = table_at + 1 + 4 * k
            Q[int(p[at])] += p[at + 1] * math.sin(p[at + 2] * time + p[at + 3])


@dataclass(frozen=True)
class RecordedCommands(Controller):
    """Row k of the recorded data is the commands held from sample k on."""

    width: float = 4.0

    @staticmethod
    def step(k, rec, held, width):
        m = int(width)
        for i in range(m):
            held[i] = rec[m * k + i]


def random_law(rng: random.Random) -> Quadratic:
    """The testbed's map roughly, or a linear one; one in three without a gap."""
    gap = 1.0 if rng.random() < 0.33 else rng.uniform(1.0, 1.5)
    if rng.random() < 0.3:
        return Quadratic(0.0, 0.0, rng.uniform(2.0, 8.0), 0.0, gap)
    size = rng.uniform(0.4, 1.2)
    slope = rng.choice((0.0, 0.15))
    return Quadratic(slope, 6.4 * LBF_IN * size, 0.14 * LBF_IN, 0.37 * LBF_IN, gap)


def random_command(rng: random.Random) -> float:
    """Volts; one in five is off."""
    return 0.0 if rng.random() < 0.2 else rng.uniform(0.5, 9.0)


def random_run(kind: str, seed: int, t_end: float = 3.0) -> Scenario:
    """A reproducible random run of PTER; ``kind`` is one of ``KINDS``."""
    rng = random.Random(f"{kind} {seed}")
    alpha, beta = rng.uniform(120, 200) * LBF_IN, rng.uniform(30, 75) * LBF_IN
    gamma = rng.uniform(-40.0, 40.0) * LBF_IN
    device = Pter(alpha, beta, gamma, 0.92, 0.61)
    lines = tuple(
        (float(rng.randrange(2)), rng.uniform(5, 40), rng.uniform(2.0, 20.0), rng.uniform(0, 6.28))
        for _ in range(4)
    )
    load = Sines(rng.uniform(-15, 15), rng.uniform(-15, 15), lines)
    clutches = tuple(Clutch(random_law(rng)) for _ in range(4))
    q = (rng.uniform(0.4, 1.2), rng.uniform(1.0, 2.0))
    qd = (0.0, 0.0) if rng.random() < 0.5 else (rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5))
    start = tuple(random_command(rng) for _ in range(4))
    run = Scenario(
        f"{kind} {seed}", device, clutches, q, qd, t_end,
        loads=(load,), command=start, excitation=start,
    )  # fmt: skip
    if kind == "constant":
        return run.replace(command=tuple(random_command(rng) for _ in range(4)))
    period = 1.0 / float(kind.split()[-2])
    if kind.startswith("controller"):
        path = ImpedanceToLine(
            rng.uniform(2e3, 8e3), rng.uniform(50, 400), 0.0, rng.uniform(0.4, 0.8), 0.0
        )
        table = LookupTable(rng.uniform(300, 700) * LBF_IN)
        return run.replace(controllers=((path, 1), (table, 1)), period=period)
    samples = int(t_end / period) + 2
    hold = rng.choice((1, 1, 3, 10))
    rows: list[float] = []
    row = [random_command(rng) for _ in range(4)]
    for k in range(samples):
        if k % hold == 0:
            row = [random_command(rng) if rng.random() < 0.5 else v for v in row]
        rows += row
    return run.replace(controllers=((RecordedCommands(), 1),), period=period, rec=tuple(rows))
