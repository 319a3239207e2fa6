"""Equations (24)-(29): the special cases of Case 7.1, one clutch at its breakaway torque."""

from __future__ import annotations

from functools import partial

import sympy as sp

from derivations.audit.case_algebra import ACCELERATIONS, IN_A, IN_B, TAU, V, equations_of_motion
from derivations.audit.compare import same
from derivations.audit.verdict import Entry

B1, B2, B3 = sp.symbols("tau_1brk tau_2brk tau_3brk", positive=True)
LIMITS = {1: B1, 2: B2, 3: B3}


def at_breakaway(clutch: int, direction: int) -> dict[int, sp.Expr]:
    """Torques of clutches 1, 2, 3 at rest, clutch 4 free, one of them at +-breakaway."""
    rest = {a: 0 for a in ACCELERATIONS} | {V[0]: 0, V[1]: 0, TAU[3]: 0}
    system = [
        e.subs(rest).subs(TAU[clutch - 1], direction * LIMITS[clutch])
        for e in equations_of_motion()
    ]
    others = [i for i in LIMITS if i != clutch]
    (solution,) = sp.linsolve(system, [TAU[i - 1] for i in others])
    return dict(zip(others, solution, strict=True)) | {clutch: direction * LIMITS[clutch]}


def _printed() -> dict[tuple[int, int], sp.Expr]:
    """tau_xy as printed, with the earlier ones inserted: x at breakaway, torque of y."""
    tau13 = -IN_A - B1
    tau23 = B2 + IN_B
    return {
        (1, 3): tau13, (1, 2): -IN_B + tau13,
        (2, 3): tau23, (2, 1): -tau23 - IN_A,
        (3, 1): -IN_A - B3, (3, 2): -IN_B + B3,
    }  # fmt: skip


NUMBERS = {(1, 3): "24", (1, 2): "25", (2, 3): "26", (2, 1): "27", (3, 1): "28", (3, 2): "29"}


def _agrees(case: tuple[int, int], directions: tuple[int, ...]) -> bool:
    x, y = case
    return all(same(_printed()[case], at_breakaway(x, d)[y]) for d in directions)


def entries() -> list[Entry]:
    """Entries of equations (24)-(29)."""
    return [
        Entry(
            number,
            f"Case 7.1: torque of clutch {y} with clutch {x} at breakaway",
            "symbolically: (21) at rest, clutch 4 free, both directions of the breakaway torque",
            partial(_agrees, (x, y), (1, -1)),
            condition=f"clutch {x} at breakaway in the positive direction; the case with "
            f"-tau_{x},breakaway is needed as well",
            conditional=partial(_agrees, (x, y), (1,)),
        )
        for (x, y), number in NUMBERS.items()
    ]
