"""Equations (21) in the thesis's own symbols, solved for the torques of a case."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.geometry import CLUTCH_MAP
from derivations.symbols import QDD
from derivations.symbols import TAU as TAU

M = sp.Matrix(2, 2, sp.symbols("M11 M12 M21 M22"))
V = sp.Matrix(sp.symbols("V1 V2"))
IN_A, IN_B = sp.symbols("tau_inA tau_inB")
ACCELERATIONS = tuple(QDD)


def equations_of_motion() -> list[sp.Expr]:
    """(21) as two expressions that are zero."""
    torques = CLUTCH_MAP.T * sp.Matrix(TAU) + sp.Matrix([IN_A, IN_B])
    return list(M * QDD + V - torques)


def case_torque(
    stuck: tuple[int, ...], constraints: list[sp.Expr], at_rest: bool = False
) -> dict[sp.Symbol, sp.Expr] | None:
    """Torques of the stuck clutches (1-based) from (21) and constraints that are zero.

    ``at_rest``: both links stand still, so V = 0, and the other clutches are not applied.
    None if the constraints do not determine the torques.
    """
    unknowns = [TAU[i - 1] for i in stuck]
    system = equations_of_motion() + list(constraints)
    if at_rest:
        others = {t: 0 for t in TAU if t not in unknowns}
        system = [e.subs(others).subs({V[0]: 0, V[1]: 0}) for e in system]
    solutions = sp.linsolve(system, [*ACCELERATIONS, *unknowns])
    for solution in solutions:
        torques = solution[len(ACCELERATIONS) :]
        undetermined = set(ACCELERATIONS) | set(unknowns)
        if not any(t.free_symbols & undetermined for t in torques):
            return dict(zip(unknowns, torques, strict=True))
    return None


@cache
def free(stuck: tuple[int, ...]) -> dict[sp.Symbol, sp.Expr]:
    """Torques that hold the stuck clutches while the others slip."""
    rows = [CLUTCH_MAP[i - 1, :] for i in stuck]
    torques = case_torque(stuck, [(row * QDD)[0] for row in rows])
    if torques is None:
        raise ValueError(f"the torques of clutches {stuck} are not unique")
    return torques


@cache
def resting(stuck: tuple[int, ...]) -> dict[sp.Symbol, sp.Expr]:
    """Torques of two stuck clutches with everything at rest and the other two not applied."""
    torques = case_torque(stuck, list(ACCELERATIONS), at_rest=True)
    if torques is None:
        raise ValueError(f"the torques of clutches {stuck} are not unique")
    return torques
