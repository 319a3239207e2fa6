"""Torque maps of clutches, from excitation [V] and slip speed [rad/s] to torque [N m].

Of surfaces that rub along a length, from slip speed [m/s] to force [N].
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..clutch import TorqueLaw
from ..known_units import INCH, LBF
from ..part import parameter

#: One pound-force inch in N m, exactly.
LBF_IN = LBF * INCH


@dataclass(frozen=True)
class LinearTorque(TorqueLaw):
    """Torque proportional to excitation up to the rated torque, independent of speed.

    The map of the reduced-order tests (thesis 3.2.3.4): ``break_torque`` equals ``slip_torque``
    times ``ratio``.

    Parameters
    ----------
    rated : float
        Slip torque at ``full_scale`` [N m or N].
    full_scale : float
        [V].
    ratio : float
        Breakaway torque over slip torque.
    """

    rated: float = parameter("coordinate force", low=0.0)
    full_scale: float = parameter("voltage", 10.0, above=0.0)
    ratio: float = parameter("dimensionless", 1.0)

    scaled: ClassVar[tuple[str, ...]] = ("rated",)
    breaking: ClassVar[tuple[str, ...]] = ("ratio",)

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
    the defaults are the coefficients as printed, in lb-in, converted.
    """

    scale: float = parameter("dimensionless", 1.0)
    slope: float = parameter("per coordinate speed", 0.154, source="thesis (39)")
    offset: float = parameter("dimensionless", 0.9409, source="thesis (39)")
    a: float = parameter("force a squared volt", 6.439 * LBF_IN, source="thesis (39)")
    b: float = parameter("force a volt", 0.137 * LBF_IN, source="thesis (39)")
    c: float = parameter("coordinate force", 0.371 * LBF_IN, source="thesis (39)")
    d: float = parameter("force a squared volt", 6.648 * LBF_IN, source="thesis (43)")
    e: float = parameter("force a volt", 6.176 * LBF_IN, source="thesis (43)")
    f: float = parameter("coordinate force", 5.253 * LBF_IN, source="thesis (43)")

    scaled: ClassVar[tuple[str, ...]] = ("scale",)
    breaking: ClassVar[tuple[str, ...]] = ("d", "e", "f")
    multiplied: ClassVar[tuple[str, ...]] = ("a", "b", "c", "d", "e", "f")
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


def modified_quadratic(v, a, b, c):
    """``a v^2 + b v + c`` above its vertex; below it the straight line from the origin to there.

    Parameters
    ----------
    v : float
        Excitation [V].
    a, b, c : float
        [N m/V^2], above 0, [N m/V], [N m].

    Returns
    -------
    float
        [N m].
    """
    vertex = -0.5 * b / a
    if v < vertex:
        return v * ((a * vertex + b) * vertex + c) / vertex
    return (a * v + b) * v + c


@dataclass(frozen=True)
class ModifiedQuadratic(TorqueLaw):
    """The torque-bar tests' map: a quadratic whose falling branch is replaced by a straight line.

    "It has a linear section that passes through the origin and the point of zero slope on the
    fitted quadratic" (thesis 4.3, Figures 11 and 12), so that torque vanishes at zero excitation.
    A quadratic that rises from 0 V on (``b >= 0``) has no such section. Independent of speed. The
    thesis does not print the coefficients.

    Parameters
    ----------
    a, b, c : float
        Slip torque ``a v^2 + b v + c`` [N m/V^2, N m/V, N m; of a length in N].
    d, e, f : float
        Breakaway torque ``d v^2 + e v + f``, likewise.
    """

    a: float = parameter("force a squared volt", above=0.0)
    b: float = parameter("force a volt")
    c: float = parameter("coordinate force")
    d: float = parameter("force a squared volt", above=0.0)
    e: float = parameter("force a volt")
    f: float = parameter("coordinate force")

    scaled: ClassVar[tuple[str, ...]] = ("a", "b", "c", "d", "e", "f")
    breaking: ClassVar[tuple[str, ...]] = ("d", "e", "f")
    uses: ClassVar[tuple] = (modified_quadratic,)

    @staticmethod
    def slip_torque(excitation, a, b, c):
        return modified_quadratic(excitation, a, b, c)

    @staticmethod
    def break_torque(excitation, d, e, f):
        return modified_quadratic(excitation, d, e, f)
