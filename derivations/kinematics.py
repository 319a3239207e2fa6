"""Tip, Jacobians and their rates, the singular pose, and the clutch map's rate."""

from __future__ import annotations

import sympy as sp

from derivations.geometry import CLUTCH_MAP, TIP
from derivations.symbols import QD, Q
from derivations.tidy import tidy


def tip_jacobian() -> sp.Matrix:
    """d(tip)/dq (2, 2) [m]: the matrix of equation (9)."""
    return TIP.jacobian(Q)


def rate(matrix: sp.Matrix) -> sp.Matrix:
    """Total time derivative of a matrix that depends on the coordinates only."""
    return sum((matrix.diff(q) * qd for q, qd in zip(Q, QD, strict=True)), sp.zeros(*matrix.shape))


def tip_jacobian_rate() -> sp.Matrix:
    """Jdot qd (2,) [m/s^2]: tip acceleration at zero generalized acceleration."""
    return (rate(tip_jacobian()) * QD).applyfunc(tidy)


def clutch_map_rate() -> sp.Matrix:
    """Cdot qd (4,) [rad/s^2]: zero, the clutch map of PTER is constant."""
    return rate(CLUTCH_MAP) * QD


def jacobian_of_clutches(first: int, second: int) -> sp.Matrix:
    """d(tip)/d(clutch angles) (2, 2) [m] for an independent pair of clutches, 1-based.

    Clutches 1 and 2 give equation (9), clutches 3 and 4 equation (10).
    """
    rows = sp.Matrix.vstack(CLUTCH_MAP[first - 1, :], CLUTCH_MAP[second - 1, :])
    return (tip_jacobian() * rows.inv()).applyfunc(tidy)


def determinant() -> sp.Expr:
    """det J = l_A l_D cos(th1 - th2) [m^2]: zero where links A and D are aligned."""
    return tidy(tip_jacobian().det())
