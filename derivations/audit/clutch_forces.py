"""Equations (49)-(53): tip force of each clutch, and the velocity controller's torque."""

from __future__ import annotations

import math
from functools import partial

from derivations.audit.compare import random_points
from derivations.audit.verdict import Entry

L_A, L_D = 0.92, 0.61
ROWS = ((1, 0), (0, 1), (1, -1), (1, 1))
STATES = [
    (s[:2], s[2:]) for s in random_points(400, 3, 4, math.pi) if abs(math.cos(s[0] - s[1])) > 0.05
]


def jacobian(th1: float, th2: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Velocity Jacobian of equation (9)."""
    return (
        (-L_A * math.sin(th1), -L_D * math.cos(th2)),
        (L_A * math.cos(th1), -L_D * math.sin(th2)),
    )


def _solve(matrix: tuple, right: tuple[float, float]) -> tuple[float, float]:
    (a, b), (c, d) = matrix
    det = a * d - b * c
    return ((d * right[0] - b * right[1]) / det, (a * right[1] - c * right[0]) / det)


def tip_force(clutch: int, q: list[float], rates: list[float], force_jacobian: bool) -> tuple:
    """(49)-(52): [J]^-1 times the signed unit torque; [J] read as velocity or force Jacobian."""
    row = ROWS[clutch - 1]
    sign = math.copysign(1.0, row[0] * rates[0] + row[1] * rates[1])
    torque = (-sign * row[0], -sign * row[1])
    j = jacobian(*q)
    return _solve(tuple(zip(*j, strict=True)) if force_jacobian else j, torque)


def power(clutch: int, q: list[float], qd: list[float], force_jacobian: bool,
          rates: list[float]) -> float:  # fmt: skip
    """Power of the force on the tip; a friction clutch may only take energy."""
    j = jacobian(*q)
    velocity = [row[0] * qd[0] + row[1] * qd[1] for row in j]
    force = tip_force(clutch, q, rates, force_jacobian)
    return force[0] * velocity[0] + force[1] * velocity[1]


def passive(clutch: int, force_jacobian: bool, dots: bool) -> bool:
    """Whether the force takes energy in every random state."""
    return all(power(clutch, q, qd, force_jacobian, qd if dots else q) <= 1e-9 for q, qd in STATES)


def _torque(force: float, turn: float) -> float:
    return 4e4 * force * abs(turn)


def entries() -> list[Entry]:
    """Entries of equations (49)-(53)."""
    names = ("clutch 1", "clutch 2", "clutch 3", "clutch 4")
    found = [
        Entry(
            str(49 + k), f"tip force of {name}",
            f"power on the tip in {len(STATES)} random states: never positive",
            partial(passive, k + 1, False, dots=False), "dots",
            partial(passive, k + 1, False, dots=True),
            condition="[J] is the force Jacobian, rows 1 and 2 of (11), the transpose of (9)",
            conditional=partial(passive, k + 1, True, dots=True),
            remark="with the velocity Jacobian of (9) the force would add energy in some states",
        )
        for k, name in enumerate(names)
    ]  # fmt: skip
    found.append(
        Entry(
            "53",
            "torque from the angle to the desired velocity",
            "a magnitude may not be negative: evaluated for both signs of f_N",
            lambda: all(_torque(f, turn) >= 0 for f in (-1.0, 1.0) for turn in (-0.3, 0.3)),
            condition="f_N >= 0: counted towards the path, as the selected clutch pushes there",
            conditional=lambda: (
                all(_torque(1.0, turn) >= 0 for turn in (-0.3, 0.3)) and _torque(1.0, 0.0) == 0.0
            ),
        )
    )
    return found
