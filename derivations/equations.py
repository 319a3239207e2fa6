"""The named equations of PTER that the numerical package needs: names, layout, expressions."""

from __future__ import annotations

import sympy as sp

from derivations import geometry, kinematics, lagrangian
from derivations.bindings import bindings
from derivations.codegen import Function
from derivations.symbols import TH1, TH2

HEADER = '''"""PTER's equations: inertia, velocity terms, clutch map, tip, inverse kinematics.

Plain scalar functions; lists or one-dimensional float64 arrays; valid under ``numba.njit``.
q = [theta_1, theta_2] [rad], qd [rad/s],
p = [alpha, beta, gamma, l_a, l_d] in [kg m^2, kg m^2, kg m^2, m, m].
theta_1 runs from the x axis to link A; theta_2 from the y axis to link D, so that
tip = l_a (cos theta_1, sin theta_1) + l_d (-sin theta_2, cos theta_2).
"""
'''

PARAMETER_ORDER = ("alpha", "beta", "gamma", "l_a", "l_d")

INVERSE_KINEMATICS = '''
def inverse_kinematics(x, y, branch, p, out):
    """Angles [rad] that put the tip at (x, y) [m]; out[2] = [theta_1, theta_2].

    branch >= 0 takes the elbow with cos(theta_1 - theta_2) >= 0 (det J >= 0, PTER's), branch < 0
    the other one. theta_1 is in (-pi, pi], theta_2 - theta_1 in [-3 pi/2, pi/2]. Returns 0, or 1
    (out untouched) if the point is out of reach or not a number. Corrected form of the thesis's
    (3)-(6), valid in all quadrants. At the origin (only if l_a = l_d) theta_1 is arbitrary.
    """
    l_a = p[3]
    l_d = p[4]
    r = hypot(x, y)
    outer = (l_a + l_d - r) * (l_a + l_d + r)
    inner = (r - abs(l_a - l_d)) * (r + abs(l_a - l_d))
    # Rounding of a point on the border of the workspace is not out of reach: four ulp of r^2.
    slack = 4.0 * 2.220446049250313e-16 * (l_a + l_d) * (l_a + l_d)
    if not (outer >= -slack and inner >= -slack):
        return 1
    sine = sqrt(max(outer, 0.0) * max(inner, 0.0))
    if branch < 0:
        sine = -sine
    cosine = r * r - l_a * l_a - l_d * l_d
    elbow = atan2(sine, cosine)
    along = l_a + l_d * cos(elbow)
    across = l_d * sin(elbow)
    theta_1 = atan2(along * y - across * x, along * x + across * y)
    out[0] = theta_1
    out[1] = theta_1 + elbow - 1.5707963267948966
    return 0
'''


def _function(name: str, arguments: str, doc: str, outputs: object, into: str = "") -> Function:
    names = tuple(arguments.split())
    listed = tuple(outputs) if isinstance(outputs, sp.MatrixBase) else (outputs,)
    return Function(name, names, doc, bindings(names), listed, into)


def functions() -> tuple[Function, ...]:
    """Every generated function of ``pter_equations``, in the order of the text."""
    motion = lagrangian.from_lumped()
    return (
        _function(
            "mass_matrix",
            "q p out",
            "M, row-major out[4] [kg m^2]; equation (15).",
            motion.mass_matrix,
            "out",
        ),
        _function(
            "velocity_terms",
            "q qd p out",
            "V, out[2] [N m]; equation (15).",
            motion.velocity_terms,
            "out",
        ),
        _function(
            "clutch_map",
            "q p out",
            "C, row-major out[8] (4 x 2) [1]: slip velocities are C qd; (7), (8), (19), (20).",
            geometry.CLUTCH_MAP,
            "out",
        ),
        _function(
            "clutch_map_rate",
            "q qd p out",
            "Cdot qd, out[4] [rad/s^2]: zero, since C is constant.",
            kinematics.clutch_map_rate(),
            "out",
        ),
        _function("tip", "q p out", "Tip (x, y), out[2] [m]; (1), (2).", geometry.TIP, "out"),
        _function(
            "tip_jacobian",
            "q p out",
            "d(tip)/dq, row-major out[4] [m]; equation (9).",
            kinematics.tip_jacobian(),
            "out",
        ),
        _function(
            "tip_jacobian_rate",
            "q qd p out",
            "Jdot qd, out[2] [m/s^2]: tip acceleration at zero qdd.",
            kinematics.tip_jacobian_rate(),
            "out",
        ),
        _function(
            "kinetic_energy",
            "q qd p",
            "Kinetic energy [J].",
            lagrangian.lumped_kinetic_energy(),
        ),
        _function(
            "singularity",
            "q p",
            "cos(theta_1 - theta_2) [1]; det J = l_a l_d times this, zero where A and D align.",
            sp.cos(TH1 - TH2),
        ),
    )
