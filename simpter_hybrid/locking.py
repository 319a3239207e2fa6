"""Locks that contradict each other: stuck clutches that the pose does not allow together."""

from __future__ import annotations

from typing import Any

#: Slip of a stuck clutch, relative to the speeds it is made of, that is no longer rounding.
NEAR = 1e-9


def contradiction(md: Any, w: Any, y: list[float]) -> str:
    """Why the present stuck set cannot be, or '' if it can.

    With a map that depends on the configuration a clutch that was redundant when its set locked may
    stop being so: the others then allow a motion in which it would have to slip.

    Parameters
    ----------
    md, w : Model, Work
        In the present mode.
    y : list of float
        State that satisfies the independent clutches.
    """
    if md.constant:
        return ""
    n, rank = md.n, w.meta[0]
    independent = {w.rows[k] for k in range(rank)}
    md.map(y, md.p, w.C)
    for i in range(md.m):
        if w.mode[i] != 0 or i in independent:
            continue
        parts = [w.C[i * n + j] * y[n + j] for j in range(n)]
        slip, size = sum(parts), sum(map(abs, parts))
        if abs(slip) > NEAR * max(size, 1e-6):
            others = ", ".join(str(k + 1) for k in sorted(independent))
            return (
                f"incompatible locking: clutch {i + 1} was locked together with clutches {others} "
                f"where they left it no motion, but the configuration has changed and it would now "
                f"slip at {slip:.3g} rad/s; three or more locks at once need a map that stays "
                "dependent; let one of them go (a lower command) or change the clutch map"
            )
    return ""
