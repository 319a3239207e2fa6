"""Integration methods written out for the compiled kernel (coefficients as SciPy holds them).

Written out, a stage is one loop over the state; as loops over coefficients the sums cost as much
as the right-hand side.  ``stage``, ``error_sums`` and ``last_rows`` belong to the compiled kernel
only, as do the values of the numbers below.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from scipy.integrate import RK45
from scipy.integrate._ivp import dop853_coefficients as hairer

#: A method's numbers as the kernel's modules name them; ``unrolled`` gives them their values.
STAGES = EXTENDED = ROWS = BETWEEN = 0
EXPONENT = SPREAD = 0.0


class Tableau(NamedTuple):
    """Coefficients of a method, and what ``screen`` goes by in its steps.

    ``stages`` make a step; the one after them is the derivative at its end, and those beyond serve
    the dense output.  ``error``: weights of the error estimate; ``correction``: of the second one,
    of third order (DOP853).  ``last``: of the dense output's rows from the fourth on.
    """

    stages: int
    abscissae: Sequence[float]
    weights: Sequence[Sequence[float]]
    error: Sequence[float]
    correction: Sequence[float]
    last: Sequence[Sequence[float]]
    exponent: float
    spread: float
    between: Sequence[float]


TABLEAUX = {
    # Hairer, Norsett & Wanner 1993.
    "DOP853": Tableau(
        hairer.N_STAGES,
        hairer.C,
        [row[:s] for s, row in enumerate(hairer.A)],
        hairer.E5,
        hairer.E3,
        hairer.D,
        exponent=-1.0 / 8.0,
        spread=2.0,
        between=(0.184, 0.422, 0.511, 0.754, 0.93),
    ),
    # Dormand & Prince 1980, continued by Shampine 1986.  Of ``x (F0 + z (F1 + x (F2 + z F3)))``,
    # z = 1 - x, only F3 has a fourth power of x: its weights are those that SciPy gives to that.
    "RK45": Tableau(
        RK45.n_stages,
        [*RK45.C, 1.0],
        [*(row[:s] for s, row in enumerate(RK45.A)), RK45.B],
        RK45.E,
        (),
        [RK45.P[:, 3]],
        exponent=-1.0 / 5.0,
        spread=2.0,
        between=(0.1, 0.4, 0.5, 0.6, 0.7),
    ),
}


def total(weights: Sequence[float]) -> str:
    """Text of the sum of stages ``i`` at entry ``j``, weighted."""
    return " + ".join(
        f"{float(weight)!r} * K[{i} * ny + j]" for i, weight in enumerate(weights) if weight != 0.0
    )


def unrolled(method: str) -> str:
    """Text of a method's numbers, ``abscissa``, ``between`` and what ``written`` tells."""
    t = TABLEAUX[method]
    extended = len(t.weights)
    numbers = {
        "STAGES": t.stages, "EXTENDED": extended, "ROWS": 3 + len(t.last),
        "BETWEEN": len(t.between), "EXPONENT": t.exponent, "SPREAD": t.spread,
    }  # fmt: skip
    parts = [f"{name} = {value!r}" for name, value in numbers.items()]
    parts += table("abscissa", {s: t.abscissae[s] for s in range(1, extended)})
    parts += table("between", dict(enumerate(t.between)))
    parts += written(t)
    # Arrays of these never overlap: their loops become vector instructions.
    names = [f"stage_{s}" for s in range(1, extended)]
    parts.append(f"\nAPART = {('error_sums', 'last_rows', 'dense_at', *names)!r}")
    return "\n".join(parts) + "\n"


def table(name: str, values: dict[int, float]) -> list[str]:
    """Text of a function that gives the value of a number."""
    lines = [f"\ndef {name}(s):"]
    for s, value in values.items():
        lines.append(f"    if s == {s}:\n        return {float(value)!r}")
    return [*lines, "    return 1.0\n"]


def written(t: Tableau) -> list[str]:
    """Text of ``stage``, ``error_sums`` and ``last_rows``."""
    parts = []
    stages = range(1, len(t.weights))
    for s in stages:
        parts.append(f"def stage_{s}(count, ny, y, h, K, out):\n    for j in range(count):")
        parts.append(f"        out[j] = y[j] + h * ({total(t.weights[s])})\n")
    parts.append("def stage(s, count, ny, y, h, K, out):")
    for s in stages:
        parts.append(f"    if s == {s}:\n        stage_{s}(count, ny, y, h, K, out)")
    parts.append("\ndef error_sums(ny, y, y_new, K, rtol, atol):")
    parts.append("    five = 0.0\n    three = 0.0\n    for j in range(ny):")
    parts.append("        scale = atol + max(abs(y[j]), abs(y_new[j])) * rtol")
    parts.append(f"        e5 = ({total(t.error)}) / scale\n        five += e5 * e5")
    if len(t.correction):
        parts.append(f"        e3 = ({total(t.correction)}) / scale\n        three += e3 * e3")
    parts.append("    return five, three\n")
    parts.append("def last_rows(ny, h, K, F):\n    for j in range(ny):")
    for r, row in enumerate(t.last):
        parts.append(f"        F[{3 + r} * ny + j] = h * ({total(row)})")
    return parts
