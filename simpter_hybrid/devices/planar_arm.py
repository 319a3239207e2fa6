"""Three links in a plane, absolute angles; clutches at the joints and along x and y at the tip.

Derived from its kinetic and potential energy; regenerate rather than edit.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import ClassVar

from ..device import Device
from ..part import parameter


@dataclass(frozen=True)
class PlanarArm(Device):
    """Three links in a plane, absolute angles; clutches at the joints and at the tip along x and y.

    Parameters
    ----------
    m1, m2, m3 : float
        Masses [kg], centres in the middle.
    i1, i2, i3 : float
        Inertias about the centres [kg m^2].
    l1, l2, l3 : float
        Lengths [m].
    """

    m1: float = parameter("mass", 3.0)
    m2: float = parameter("mass", 2.0)
    m3: float = parameter("mass", 1.0)
    i1: float = parameter("inertia", 0.06)
    i2: float = parameter("inertia", 0.03)
    i3: float = parameter("inertia", 0.01)
    l1: float = parameter("length", 0.5)
    l2: float = parameter("length", 0.4)
    l3: float = parameter("length", 0.25)

    coordinates: ClassVar[tuple[str, ...]] = ("q1", "q2", "q3")
    coordinate_dimensions: ClassVar[tuple[str, ...]] = ()
    surfaces: ClassVar[tuple[str, ...]] = ("base", "elbow", "wrist", "tip x", "tip y")
    constant_clutch_map: ClassVar[bool] = False

    @staticmethod
    def mass_matrix(q, p, out):
        """M, n*n."""
        q1 = q[0]
        q2 = q[1]
        q3 = q[2]
        m1 = p[0]
        m2 = p[1]
        m3 = p[2]
        i1 = p[3]
        i2 = p[4]
        i3 = p[5]
        l1 = p[6]
        l2 = p[7]
        l3 = p[8]
        x0 = l1 * l1
        x1 = l1 * m3
        x2 = l2 * cos(q1 - q2)
        x3 = 0.5 * l1 * m2 * x2 + x1 * x2
        x4 = -q3
        x5 = 0.5 * l3
        x6 = x1 * x5 * cos(q1 + x4)
        x7 = l2 * l2
        x8 = l2 * m3 * x5 * cos(q2 + x4)
        out[0] = i1 + (1.0 / 4.0) * m1 * x0 + m2 * x0 + m3 * x0
        out[1] = x3
        out[2] = x6
        out[3] = x3
        out[4] = i2 + (1.0 / 4.0) * m2 * x7 + m3 * x7
        out[5] = x8
        out[6] = x6
        out[7] = x8
        out[8] = i3 + (1.0 / 4.0) * (l3 * l3) * m3

    @staticmethod
    def velocity_terms(q, qd, p, out):
        """V, n."""
        q1 = q[0]
        q2 = q[1]
        q3 = q[2]
        w1 = qd[0]
        w2 = qd[1]
        w3 = qd[2]
        m2 = p[1]
        m3 = p[2]
        l1 = p[6]
        l2 = p[7]
        l3 = p[8]
        x0 = w2 * w2
        x1 = l1 * m3
        x2 = l2 * sin(q1 - q2)
        x3 = x1 * x2
        x4 = 0.5 * x0
        x5 = l1 * m2 * x2
        x6 = w3 * w3
        x7 = -q3
        x8 = x1 * sin(q1 + x7)
        x9 = w1 * w1
        x10 = 0.5 * x9
        x11 = sin(q2 + x7)
        out[0] = 0.5 * l3 * x6 * x8 + x0 * x3 + x4 * x5
        out[1] = 0.5 * l2 * l3 * m3 * x11 * x6 - x10 * x5 - x3 * x9
        out[2] = -l2 * l3 * m3 * x11 * x4 - l3 * x10 * x8

    @staticmethod
    def clutch_map(q, p, out):
        """C, m*n."""
        q1 = q[0]
        q2 = q[1]
        q3 = q[2]
        l1 = p[6]
        l2 = p[7]
        l3 = p[8]
        out[0] = 1.0
        out[1] = 0.0
        out[2] = 0.0
        out[3] = -1.0
        out[4] = 1.0
        out[5] = 0.0
        out[6] = 0.0
        out[7] = -1.0
        out[8] = 1.0
        out[9] = -l1 * sin(q1)
        out[10] = -l2 * sin(q2)
        out[11] = -l3 * sin(q3)
        out[12] = l1 * cos(q1)
        out[13] = l2 * cos(q2)
        out[14] = l3 * cos(q3)

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        """Cdot qd, m."""
        q1 = q[0]
        q2 = q[1]
        q3 = q[2]
        w1 = qd[0]
        w2 = qd[1]
        w3 = qd[2]
        l1 = p[6]
        l2 = p[7]
        l3 = p[8]
        x0 = l1 * (w1 * w1)
        x1 = l2 * (w2 * w2)
        x2 = l3 * (w3 * w3)
        out[0] = 0.0
        out[1] = 0.0
        out[2] = 0.0
        out[3] = -x0 * cos(q1) - x1 * cos(q2) - x2 * cos(q3)
        out[4] = -x0 * sin(q1) - x1 * sin(q2) - x2 * sin(q3)

    @staticmethod
    def tip(q, p, out):
        """Tip, 2."""
        q1 = q[0]
        q2 = q[1]
        q3 = q[2]
        l1 = p[6]
        l2 = p[7]
        l3 = p[8]
        out[0] = l1 * cos(q1) + l2 * cos(q2) + l3 * cos(q3)
        out[1] = l1 * sin(q1) + l2 * sin(q2) + l3 * sin(q3)

    @staticmethod
    def tip_jacobian(q, p, out):
        """Jacobian of the tip, 2*n [m/rad]."""
        q1 = q[0]
        q2 = q[1]
        q3 = q[2]
        l1 = p[6]
        l2 = p[7]
        l3 = p[8]
        out[0] = -l1 * sin(q1)
        out[1] = -l2 * sin(q2)
        out[2] = -l3 * sin(q3)
        out[3] = l1 * cos(q1)
        out[4] = l2 * cos(q2)
        out[5] = l3 * cos(q3)

    @staticmethod
    def tip_jacobian_rate(q, qd, p, out):
        """Jdot qd, 2."""
        q1 = q[0]
        q2 = q[1]
        q3 = q[2]
        w1 = qd[0]
        w2 = qd[1]
        w3 = qd[2]
        l1 = p[6]
        l2 = p[7]
        l3 = p[8]
        x0 = l1 * (w1 * w1)
        x1 = l2 * (w2 * w2)
        x2 = l3 * (w3 * w3)
        out[0] = -x0 * cos(q1) - x1 * cos(q2) - x2 * cos(q3)
        out[1] = -x0 * sin(q1) - x1 * sin(q2) - x2 * sin(q3)
