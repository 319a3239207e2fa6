"""Reduced equations for a stuck set: motion left, holding torques, stick margin.

M qdd + V = g + C_S' tau_S with C_S qdd = 0 (constant C). With qd = N v, the holding torques drop
out: N' M N vd = N' (g - V). What the stuck clutches must supply is h = M qdd + V - g = C_S' tau_S.
"""

from __future__ import annotations

import sympy as sp

from derivations.lagrangian import EquationsOfMotion
from derivations.stuck_sets import StuckSet, facet_normals


def reduced_mass(motion: EquationsOfMotion, stuck: StuckSet) -> sp.Matrix:
    """N' M N (n - rank, n - rank) [kg m^2]."""
    n = stuck.null_space
    return (n.T * motion.mass_matrix * n).applyfunc(sp.expand)


def acceleration(motion: EquationsOfMotion, stuck: StuckSet, force: sp.Matrix) -> sp.Matrix:
    """qdd (n,) [rad/s^2] of the motion that the stuck set leaves; C_S qdd is zero identically."""
    n = stuck.null_space
    if n.cols == 0:
        return sp.zeros(n.rows, 1)
    right = n.T * (force - motion.velocity_terms)
    mass = reduced_mass(motion, stuck)
    return n * (mass.adjugate() * right / mass.det())


def force_to_hold(motion: EquationsOfMotion, stuck: StuckSet, force: sp.Matrix) -> sp.Matrix:
    """h = M qdd + V - g (n,) [N m]: the generalized force that the stuck clutches supply."""
    qdd = acceleration(motion, stuck, force)
    return motion.mass_matrix * qdd + motion.velocity_terms - force


def holding_torques(motion: EquationsOfMotion, stuck: StuckSet, force: sp.Matrix) -> sp.Matrix:
    """tau_S (len(S),) [N m] from C_S' tau_S = h, for an independent set.

    Raises
    ------
    ValueError
        If the set is redundant: then only the stick margin is determined.
    """
    if not stuck.independent:
        names = ", ".join(str(i + 1) for i in stuck.clutches)
        raise ValueError(f"holding torques of clutches {names} are not unique: use stick_margins")
    rows = stuck.rows
    return (rows * rows.T).inv() * rows * force_to_hold(motion, stuck, force)


def stick_margins(
    motion: EquationsOfMotion, stuck: StuckSet, force: sp.Matrix, breakaway: tuple[sp.Symbol, ...]
) -> tuple[sp.Expr, ...]:
    """Margin [N m] of every facet of what S can hold; the set holds while all are >= 0."""
    to_hold = force_to_hold(motion, stuck, force)
    margins = []
    for normal in facet_normals(stuck):
        reach = stuck.rows * normal
        capacity = sum(abs(reach[k]) * breakaway[i] for k, i in enumerate(stuck.clutches))
        margins.append(capacity - sp.Abs(normal.dot(to_hold)))
    return tuple(margins)
