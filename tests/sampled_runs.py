"""Runs that tests of sampling, measures, files and pictures share; each is computed once."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass, replace

import numpy as np

from simpter_hybrid.applied_load import Load
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.device import Device
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.scenario import Scenario
from simpter_hybrid.trajectory import Trajectory


@functools.cache
def baseline() -> Trajectory:
    """PTER's line-following run at 30 Hz."""
    return simulate(load("line-y24-30hz"))


@dataclass(frozen=True)
class SpringBlock(Device):
    """A block on the ground on a spring: no tip, one coordinate [m], one surface."""

    mass: float = 2.0
    stiffness: float = 50.0

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

    @staticmethod
    def potential_energy(q, p):
        return 0.5 * p[1] * q[0] * q[0]


@dataclass(frozen=True)
class Puck(Device):
    """A mass in the plane that is its own tip; its one clutch stays off."""

    mass: float = 1.0

    coordinates = ("x", "y")
    surfaces = ("table",)

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

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def tip(q, p, out):
        out[0] = q[0]
        out[1] = q[1]

    @staticmethod
    def tip_jacobian(q, p, out):
        out[0] = 1.0
        out[1] = 0.0
        out[2] = 0.0
        out[3] = 1.0

    @staticmethod
    def tip_jacobian_rate(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0


@dataclass(frozen=True)
class TurningPush(Load):
    """A tip force of constant size [N] that turns at a constant rate [rad/s]."""

    size: float
    rate: float

    @staticmethod
    def tip_force(time, size, rate, out):
        out[0] = size * math.cos(rate * time)
        out[1] = size * math.sin(rate * time)


@functools.cache
def turning() -> Trajectory:
    """A free puck under 3 N that turn at 10 rad/s, for 1 s."""
    push = TurningPush(3.0, 10.0)
    clutch = Clutch(LinearTorque(rated=1.0))
    return simulate(
        Scenario("turning", Puck(), (clutch,), (0.0, 0.0), (0.0, 0.0), 1.0, loads=(push,))
    )


def engaged(torque: float, ratio: float = 1.0) -> Clutch:
    """A clutch that is on from the start at full scale: slip torque ``torque`` [N m]."""
    law = LinearTorque(rated=torque, ratio=ratio)
    return Clutch(law, time_constant=0.0, delay=0.0, threshold=-1.0)


#: Coulomb force [N] and initial displacement [m] of ``oscillator``.
FORCE, START = 3.0, 0.5


@functools.cache
def oscillator() -> Trajectory:
    """The spring block let go at ``START`` under Coulomb friction ``FORCE``, until it rests."""
    return simulate(
        Scenario(
            "oscillator",
            SpringBlock(),
            (engaged(FORCE),),
            (START,),
            (0.0,),
            3.0,
            command=(10.0,),
            excitation=(10.0,),
        )
    )


@dataclass(frozen=True)
class TipRamp(Load):
    """A tip force that grows with time [N/s]."""

    x: float
    y: float

    @staticmethod
    def tip_force(time, x, y, out):
        out[0] = x * time
        out[1] = y * time


#: Slip torques of the clutches of ``locked`` [N m].
TORQUES = (6.0, 5.0, 9.0, 9.0)


@functools.cache
def locked(ratio: float = 1.0) -> Trajectory:
    """PTER with all four clutches stuck, pushed until some let go (Case 7.5)."""
    pter = load("line-y24-30hz")
    return simulate(
        Scenario(
            "locked",
            pter.device,
            tuple(engaged(torque, ratio) for torque in TORQUES),
            pter.q,
            (0.0, 0.0),
            1.5,
            loads=(TipRamp(-30.0, 10.0),),
            command=(10.0,) * 4,
            excitation=(10.0,) * 4,
        )
    )


def swings(block: SpringBlock, force: float, start: float) -> list[float]:
    """Amplitudes of the half swings of a block under Coulomb friction, about their own centres.

    Closed form: every half swing is a cosine about ``+-force/stiffness``.
    """
    offset = force / block.stiffness
    amplitudes = []
    displacement = start
    while displacement > offset:
        amplitudes.append(displacement - offset)
        displacement -= 2.0 * offset
    return amplitudes


def clutch_map_of(trajectory: Trajectory) -> np.ndarray:
    """PTER's constant clutch map."""
    out = [math.nan] * 8
    trajectory.scenario.device.functions()["clutch_map"]([0.0, 0.0], [], out)
    return np.reshape(out, (4, 2))


def same_again(trajectory: Trajectory) -> Trajectory:
    """The run computed a second time."""
    return simulate(replace(trajectory.scenario))
