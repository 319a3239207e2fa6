"""Torque maps of clutches, from excitation [V] and slip speed [rad/s] to torque [N m]."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .clutch import TorqueLaw

#: One pound-force inch in N m, exactly.
LBF_IN = 4.4482216152605 * 0.0254


@dataclass(frozen=True)
class LinearTorque(TorqueLaw):
    """Torque proportional to excitation up to the rated torque, independent of speed.

    The map of the reduced-order tests (thesis 3.2.3.4): ``break_torque`` equals ``slip_torque``
    times ``ratio``.
    """

    rated: float
    full_scale: float = 10.0
    ratio: float = 1.0

    @staticmethod
    def slip_torque(excitation, rated, full_scale):
        return rated * excitation / full_scale

    @staticmethod
    def break_torque(excitation, rated, full_scale, ratio):
        return ratio * rated * excitation / full_scale


@dataclass(frozen=True)
class TestbedTorque(TorqueLaw):
    """The testbed's maps: thesis equation (39) for slip, (43) for breakaway.

    ``slip = scale (slope speed + offset)(a v^2 + b v + c)``, ``break = scale (d v^2 + e v + f)``;
    coefficients in lb-in as printed, converted inside.
    """

    scale: float = 1.0
    slope: float = 0.154
    offset: float = 0.9409
    a: float = 6.439 * LBF_IN
    b: float = 0.137 * LBF_IN
    c: float = 0.371 * LBF_IN
    d: float = 6.648 * LBF_IN
    e: float = 6.176 * LBF_IN
    f: float = 5.253 * LBF_IN

    #: Not a test, whatever its name begins with.
    __test__: ClassVar[bool] = False

    @staticmethod
    def slip_torque(speed, excitation, scale, slope, offset, a, b, c):
        v = excitation
        return scale * (slope * speed + offset) * ((a * v + b) * v + c)

    @staticmethod
    def break_torque(excitation, scale, d, e, f):
        v = excitation
        return scale * ((d * v + e) * v + f)
