"""What ends a stretch of a run of smooth friction: stop conditions and guards of effects."""

from __future__ import annotations

from typing import Any

from .smooth_friction import Smooth


def first_met(model: Smooth, step: Any) -> tuple[int, float] | None:
    """The guard that falls first within the solver's last step and when, by bisection.

    One that has recovered by the end of the step goes unseen. Of several that fall at one instant
    the first in their order is taken, as with the exact engine.

    Parameters
    ----------
    model : Smooth
    step : OdeSolver
        After a step.

    Returns
    -------
    (int, float) or None
        Its number, from 0 (stop conditions before guards of effects), and the instant [s].
    """
    md, w = model.md, model.w
    if md.ng == 0:
        return None
    out = [0.0] * (2 * md.m + md.ng)

    def values(t: float, y: Any) -> list[float]:
        md.watch(t, y.tolist(), md.p, md.rec, w.held, w.mode, w.dmode, w.s, out)
        return out[2 * md.m :]

    first: tuple[int, float] | None = None
    for g, value in enumerate(values(step.t, step.y)):
        if value >= 0.0:
            continue
        low, high, dense = step.t_old, step.t, step.dense_output()
        for _ in range(60):
            t = 0.5 * (low + high)
            if values(t, dense(t))[g] < 0.0:
                high = t
            else:
                low = t
        if first is None or high < first[1]:
            first = g, float(high)
    return first
