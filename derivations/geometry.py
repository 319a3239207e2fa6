"""PTER from its geometry (Figure 2): four links of a parallelogram, the tip, the four clutches.

The convention under which equations (12)-(15) of the thesis come out (tests try the others):

* A runs from the main axis O along u1 = (cos th1, sin th1), length l_A.
* B runs from O along **minus** u2, with u2 = (-sin th2, cos th2): it points away from the tip side,
  length l_B.
* C is parallel to A (so l_C = l_A): from the end of B to the end of D, along u1.
  r_C is measured from the joint of B and C.
* D is parallel to B: from the joint of C and D, through the joint of A and D (at distance l_B), to
  the tip. **r_D is measured from the joint of C and D**, hence r_D - l_B in (13) and (14);
  l_D is measured from the joint of A and D to the tip, as (1) and (2) need it.
* r_A and r_B are measured from O; every I is taken about the link's own centre of mass.
* The linkage lies in a horizontal plane: no potential energy.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from derivations.symbols import (
    I_A,
    I_B,
    I_C,
    I_D,
    L_A,
    L_B,
    L_D,
    M_A,
    M_B,
    M_C,
    M_D,
    QD,
    R_A,
    R_B,
    R_C,
    R_D,
    TH1,
    TH2,
    W1,
    W2,
    Q,
)
from derivations.tidy import tidy

U1 = sp.Matrix([sp.cos(TH1), sp.sin(TH1)])
U2 = sp.Matrix([-sp.sin(TH2), sp.cos(TH2)])

#: direction of link B along u2; -1 is the one that gives the printed sign of gamma
B_SIDE = -1

#: Slip velocities of the clutches, w = C qd: clutch 1 A-ground, 2 B-ground, 3 A-B, 4 A-B geared.
CLUTCH_MAP = sp.Matrix([[1, 0], [0, 1], [1, -1], [1, 1]])


@dataclass(frozen=True)
class Link:
    """One rigid link: mass [kg], inertia about its centre of mass [kg m^2], where it is."""

    name: str
    mass: sp.Expr
    inertia: sp.Expr
    centre_of_mass: sp.Matrix
    angular_velocity: sp.Expr


def links(b_side: int = B_SIDE, r_d_from: str = "joint CD") -> tuple[Link, ...]:
    """The four links of Figure 2.

    Parameters
    ----------
    b_side
        +1 if link B points along u2, -1 if against it.
    r_d_from
        "joint CD" or "joint AD": the joint from which r_D is measured.
    """
    end_of_a = L_A * U1
    end_of_b = b_side * L_B * U2
    offset = {"joint CD": b_side * L_B, "joint AD": sp.Integer(0)}[r_d_from]
    return (
        Link("A", M_A, I_A, R_A * U1, W1),
        Link("B", M_B, I_B, b_side * R_B * U2, W2),
        Link("C", M_C, I_C, end_of_b + R_C * U1, W1),
        Link("D", M_D, I_D, end_of_a + (offset + R_D) * U2, W2),
    )


def velocity(position: sp.Matrix) -> sp.Matrix:
    """Time derivative of a position that depends on the coordinates only."""
    return position.jacobian(Q) * QD


def kinetic_energy(bodies: tuple[Link, ...]) -> sp.Expr:
    """Kinetic energy [J] of rigid links: translation of the centres of mass and rotation."""
    energy = sp.Integer(0)
    for body in bodies:
        v = velocity(body.centre_of_mass)
        energy += body.mass * v.dot(v) / 2 + body.inertia * body.angular_velocity**2 / 2
    return tidy(energy)


#: Tip of the linkage [m], equations (1) and (2).
TIP = L_A * U1 + L_D * U2
