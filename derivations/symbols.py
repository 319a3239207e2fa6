"""Symbol table: every symbol of the derivation, once, with its meaning and SI unit.

theta_1 is measured from the x axis to link A. theta_2 is measured so that link D points along
(-sin theta_2, cos theta_2), i.e. from the y axis, as equations (1) and (2) of the thesis have it.
"""

from __future__ import annotations

import sympy as sp


def _real(names: str, **assumptions: bool) -> tuple[sp.Symbol, ...]:
    return tuple(sp.symbols(names, real=True, seq=True, **assumptions))


#: generalized coordinates [rad], speeds [rad/s], accelerations [rad/s^2]
TH1, TH2 = _real("th1 th2")
W1, W2 = _real("w1 w2")
A1, A2 = _real("a1 a2")

#: lumped inertia of equations (12)-(14) [kg m^2]; M11 = 2 alpha, M22 = 2 beta
ALPHA, BETA = _real("alpha beta", positive=True)
(GAMMA,) = _real("gamma")

#: link lengths [m]; l_C = l_A because the linkage is a parallelogram
L_A, L_B, L_D = _real("l_a l_b l_d", positive=True)
#: distances of the centres of mass [m]; from where each is measured: see geometry.py
R_A, R_B, R_C, R_D = _real("r_a r_b r_c r_d")
#: link masses [kg] and moments of inertia about the centres of mass [kg m^2]
M_A, M_B, M_C, M_D = _real("m_a m_b m_c m_d", positive=True)
I_A, I_B, I_C, I_D = _real("i_a i_b i_c i_d", positive=True)

#: net generalized force [N m]: operator and slipping clutches, without velocity terms
G1, G2 = _real("g1 g2")
#: clutch torques and breakaway torques [N m]
TAU = _real("tau1 tau2 tau3 tau4")
BRK = _real("b1 b2 b3 b4", nonnegative=True)

Q = sp.Matrix([TH1, TH2])
QD = sp.Matrix([W1, W2])
QDD = sp.Matrix([A1, A2])
G = sp.Matrix([G1, G2])
