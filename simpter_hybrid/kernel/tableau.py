"""DOP853 written out (Hairer, Norsett & Wanner 1993; coefficients as SciPy holds them).

Written out, a stage is one loop over the state; as loops over coefficients the sums cost as much
as the right-hand side.  ``stage``, ``error_sums`` and ``last_rows`` belong to the compiled kernel
only.
"""

from __future__ import annotations

from collections.abc import Sequence

from scipy.integrate._ivp import dop853_coefficients as hairer

STAGES = hairer.N_STAGES
EXTENDED = hairer.N_STAGES_EXTENDED


def total(weights: Sequence[float]) -> str:
    """Text of the sum of stages ``i`` at entry ``j``, weighted."""
    return " + ".join(
        f"{float(weight)!r} * K[{i} * ny + j]" for i, weight in enumerate(weights) if weight != 0.0
    )


def unrolled() -> str:
    """Text of the numbers of stages, ``abscissa``, ``stage``, ``error_sums`` and ``last_rows``."""
    parts = [f"STAGES = {STAGES}\nEXTENDED = {EXTENDED}\n\ndef abscissa(s):"]
    for s in range(1, EXTENDED):
        parts.append(f"    if s == {s}:\n        return {float(hairer.C[s])!r}")
    parts.append("    return 1.0\n")
    for s in range(1, EXTENDED):
        # Row STAGES is the step's end.
        row = hairer.B if s == STAGES else hairer.A[s][:s]
        parts.append(f"def stage_{s}(count, ny, y, h, K, out):\n    for j in range(count):")
        parts.append(f"        out[j] = y[j] + h * ({total(row)})\n")
    parts.append("def stage(s, count, ny, y, h, K, out):")
    for s in range(1, EXTENDED):
        parts.append(f"    if s == {s}:\n        stage_{s}(count, ny, y, h, K, out)")
    parts.append("\ndef error_sums(ny, y, y_new, K, rtol, atol):")
    parts.append("    five = 0.0\n    three = 0.0\n    for j in range(ny):")
    parts.append("        scale = atol + max(abs(y[j]), abs(y_new[j])) * rtol")
    parts.append(f"        e5 = ({total(hairer.E5)}) / scale\n        five += e5 * e5")
    parts.append(f"        e3 = ({total(hairer.E3)}) / scale\n        three += e3 * e3")
    parts.append("    return five, three\n")
    parts.append("def last_rows(ny, h, K, F):\n    for j in range(ny):")
    for r, row in enumerate(hairer.D):
        parts.append(f"        F[{3 + r} * ny + j] = h * ({total(row)})")
    # Arrays of these never overlap: their loops become vector instructions.
    names = [f"stage_{s}" for s in range(1, EXTENDED)]
    parts.append(f"\nAPART = {('error_sums', 'last_rows', 'dense_at', *names)!r}")
    return "\n".join(parts) + "\n"
