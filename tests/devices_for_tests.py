"""Small devices, torque laws and loads whose motion can be written down, for tests of exactness."""

from __future__ import annotations

import math
from dataclasses import dataclass

from simpter_hybrid.applied_load import Load
from simpter_hybrid.clutch import Clutch, TorqueLaw
from simpter_hybrid.controller import Controller
from simpter_hybrid.device import Device
from simpter_hybrid.part import parameter


@dataclass(frozen=True)
class Coulomb(TorqueLaw):
    """``slip_torque = slip u``, ``break_torque = brk u``; u is the excitation in V."""

    slip: float
    brk: float

    @staticmethod
    def slip_torque(excitation, slip):
        return slip * excitation

    @staticmethod
    def break_torque(excitation, brk):
        return brk * excitation


def always_on(slip: float, brk: float) -> Clutch:
    """A clutch that is engaged from the start, held at 1 V, with constant friction."""
    return Clutch(Coulomb(slip, brk), time_constant=0.0, delay=0.0, threshold=-1.0)


@dataclass(frozen=True)
class Block(Device):
    """One mass on the ground, on a spring: ``m x'' = -k x + friction + load``."""

    mass: float = 1.0
    stiffness: float = 0.0

    coordinates = ("x",)
    surfaces = ("ground",)

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def conservative_force(q, p, out):
        out[0] = -p[1] * q[0]


@dataclass(frozen=True)
class BlockOnBelt(Device):
    """A mass on a spring, on a moving belt so heavy that nothing changes its speed."""

    mass: float = 1.0
    stiffness: float = 1.0
    belt: float = 1e30

    coordinates = ("x", "belt")
    surfaces = ("belt",)

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]
        out[1] = 0.0
        out[2] = 0.0
        out[3] = p[2]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = -1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def conservative_force(q, p, out):
        out[0] = -p[1] * q[0]
        out[1] = 0.0


@dataclass(frozen=True)
class TwoBlocks(Device):
    """Two masses side by side, each on the ground; they share nothing."""

    mass: float = 1.0

    coordinates = ("x", "y")
    surfaces = ("ground x", "ground y")

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]
        out[1] = 0.0
        out[2] = 0.0
        out[3] = p[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = 0.0
        out[2] = 0.0
        out[3] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0


@dataclass(frozen=True)
class CartAndWheel(Device):
    """A cart along a length and a wheel over an angle, each with a surface of its own."""

    mass: float = parameter("mass", 1.0)

    coordinates = ("x", "turn")
    coordinate_dimensions = ("length", "angle")
    surfaces = ("rail", "hub")

    @staticmethod
    def mass_matrix(q, p, out):
        out[0], out[1], out[2], out[3] = p[0], 0.0, 0.0, 1.0

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0], out[1] = 0.0, 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0], out[1], out[2], out[3] = 1.0, 0.0, 0.0, 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0], out[1] = 0.0, 0.0


@dataclass(frozen=True)
class Arm(Device):
    """Three links with absolute angles, five clutches; two act on the tip's Cartesian speeds.

    ``M_ij = a_ij cos(q_i - q_j)``, ``V_i = sum_j a_ij sin(q_i - q_j) qd_j^2``; clutch 1 against the
    base, 2 and 3 between neighbours, 4 and 5 along x and y at the tip (a map that depends on q).
    """

    a11: float = 3.0
    a12: float = 0.7
    a13: float = 0.3
    a22: float = 2.0
    a23: float = 0.4
    a33: float = 1.0
    l1: float = 1.0
    l2: float = 0.8
    l3: float = 0.5

    coordinates = ("q1", "q2", "q3")
    surfaces = ("base", "elbow", "wrist", "tip x", "tip y")
    constant_clutch_map = False

    @staticmethod
    def mass_matrix(q, p, out):
        c12 = p[1] * math.cos(q[0] - q[1])
        c13 = p[2] * math.cos(q[0] - q[2])
        c23 = p[4] * math.cos(q[1] - q[2])
        out[0] = p[0]
        out[1] = c12
        out[2] = c13
        out[3] = c12
        out[4] = p[3]
        out[5] = c23
        out[6] = c13
        out[7] = c23
        out[8] = p[5]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        s12 = p[1] * math.sin(q[0] - q[1])
        s13 = p[2] * math.sin(q[0] - q[2])
        s23 = p[4] * math.sin(q[1] - q[2])
        out[0] = s12 * qd[1] ** 2 + s13 * qd[2] ** 2
        out[1] = -s12 * qd[0] ** 2 + s23 * qd[2] ** 2
        out[2] = -s13 * qd[0] ** 2 - s23 * qd[1] ** 2

    @staticmethod
    def clutch_map(q, p, out):
        for i in range(15):
            out[i] = 0.0
        out[0] = 1.0
        out[3] = -1.0
        out[4] = 1.0
        out[7] = -1.0
        out[8] = 1.0
        for j in range(3):
            out[9 + j] = -p[6 + j] * math.sin(q[j])
            out[12 + j] = p[6 + j] * math.cos(q[j])

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        for i in range(5):
            out[i] = 0.0
        for j in range(3):
            out[3] -= p[6 + j] * math.cos(q[j]) * qd[j] ** 2
            out[4] -= p[6 + j] * math.sin(q[j]) * qd[j] ** 2


@dataclass(frozen=True)
class Ramp(Load):
    """A force on one coordinate, linear between (time, force) corners and constant outside them."""

    coordinate: float = 0.0
    corners: tuple[tuple[float, float], ...] = ()

    def table(self) -> tuple[float, ...]:
        return (float(len(self.corners)), *(v for corner in self.corners for v in corner))

    def breakpoints(self) -> tuple[float, ...]:
        return tuple(t for t, _ in self.corners)

    @staticmethod
    def force(time, p, table_at, coordinate, Q):
        count = int(p[table_at])
        at = table_at + 1
        value = p[at + 1]
        for k in range(1, count):
            t0 = p[at + 2 * k - 2]
            t1 = p[at + 2 * k]
            if time >= t1:
                value = p[at + 2 * k + 1]
            elif time > t0:
                part = (time - t0) / (t1 - t0)
                value = p[at + 2 * k - 1] + part * (p[at + 2 * k + 1] - p[at + 2 * k - 1])
        Q[int(coordinate)] += value


@dataclass(frozen=True)
class Waves(Load):
    """Sinusoidal generalized forces: lines of (coordinate, amplitude, angular frequency, phase)."""

    lines: tuple[tuple[float, float, float, float], ...] = ()

    def table(self) -> tuple[float, ...]:
        return (float(len(self.lines)), *(v for line in self.lines for v in line))

    @staticmethod
    def force(time, p, table_at, Q):
        for k in range(int(p[table_at])):
            at = table_at + 1 + 4 * k
            Q[int(p[at])] += p[at + 1] * math.sin(p[at + 2] * time + p[at + 3])


@dataclass(frozen=True)
class RecordedCommands(Controller):
    """Row k of the recorded data is the commands held from sample k on."""

    width: float

    @staticmethod
    def step(k, rec, held, width):
        m = int(width)
        for i in range(m):
            held[i] = rec[m * k + i]
