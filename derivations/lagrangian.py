"""Lagrange's equations of the second kind, for any number of coordinates.

M(q) qdd + V(q, qd) = generalized forces: M is the Hessian of the kinetic energy in the speeds, V
collects what depends on speeds, and the gradient of the potential if there is one.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from derivations.geometry import kinetic_energy, links
from derivations.symbols import ALPHA, BETA, GAMMA, QD, TH1, TH2, Q
from derivations.tidy import tidy


@dataclass(frozen=True)
class EquationsOfMotion:
    """``mass_matrix`` (n, n) and ``velocity_terms`` (n,) of M qdd + V = forces."""

    mass_matrix: sp.Matrix
    velocity_terms: sp.Matrix


def lagrange(
    kinetic: sp.Expr, q: sp.Matrix, qd: sp.Matrix, potential: sp.Expr = sp.S.Zero
) -> EquationsOfMotion:
    """Equations of motion from the kinetic (and potential) energy.

    Raises
    ------
    ValueError
        If the kinetic energy is not quadratic in the speeds, so that M would depend on them.
    """
    momentum = sp.Matrix([kinetic]).jacobian(qd).T
    mass = momentum.jacobian(qd).applyfunc(tidy)
    if mass.free_symbols & set(qd):
        raise ValueError(
            "kinetic energy: its second derivatives depend on the speeds; it must be quadratic "
            "in the speeds; write it as 1/2 qd' M(q) qd"
        )
    gradient = sp.Matrix([potential - kinetic]).jacobian(q).T
    velocity_terms = (momentum.jacobian(q) * qd + gradient).applyfunc(tidy)
    return EquationsOfMotion(mass, velocity_terms)


def lumped_inertia(mass: sp.Matrix) -> dict[sp.Symbol, sp.Expr]:
    """alpha, beta, gamma in terms of link data, read off a mass matrix: equations (12)-(14)."""
    coupling = sp.cancel(mass[0, 1] / sp.sin(TH2 - TH1))
    lumped = {
        ALPHA: sp.expand(mass[0, 0] / 2),
        BETA: sp.expand(mass[1, 1] / 2),
        GAMMA: sp.expand(coupling),
    }
    for symbol, value in lumped.items():
        if value.free_symbols & {TH1, TH2}:
            raise ValueError(f"{symbol} depends on the pose: the mass matrix has another form")
    return lumped


def from_links(b_side: int = -1, r_d_from: str = "joint CD") -> EquationsOfMotion:
    """Equations of motion in terms of the link data (masses, inertias, centres of mass)."""
    return lagrange(kinetic_energy(links(b_side, r_d_from)), Q, QD)


def lumped_kinetic_energy() -> sp.Expr:
    """Kinetic energy [J] in terms of alpha, beta and gamma."""
    w1, w2 = QD
    return ALPHA * w1**2 + BETA * w2**2 + GAMMA * sp.sin(TH2 - TH1) * w1 * w2


def from_lumped() -> EquationsOfMotion:
    """Equation (15): the equations of motion in terms of alpha, beta and gamma."""
    return lagrange(lumped_kinetic_energy(), Q, QD)
