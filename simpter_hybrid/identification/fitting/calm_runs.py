"""Runs that answer small changes of a model smoothly lead a fit past those that do not.

Where friction creeps before it gives way, or a switch is met or just missed, a run answers a change
of a hundredth by jumps: its error has a valley on each stair, and one such run among ten holds up a
fit that the others would lead to its end.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from .fit import FINE, Fit, Fitter
from .fitted_model import ENOUGH, FURTHER
from .residual import places

#: A run is calm where a small step does what differences of that size foretell, but for this part
#: of them.  Of creeping friction calm runs had 0.13 at most but for one (0.26), rough ones 0.46 and
#: more.
ROUGH = 0.3
#: They lead only if they are at least this part of all runs: fewer may not show what is fitted.
MOST = 0.5
#: A fit was held up if calm runs alone lower their sum of squares by this part.
HELD_UP = 0.01


def led_by_calm_runs(fitter: Fitter, values: Mapping[str, float], at: np.ndarray) -> Fit | None:
    """The fit that begins where one to the calm runs alone has ended; None if none is rough.

    Parameters
    ----------
    fitter : Fitter
    values : mapping of str to float
        Where a fit to all runs has stopped.
    at : ndarray (N,)
        Residuals there.
    """
    fine = Fitter(fitter.predictor, fitter.replays, step=FINE, unit=fitter.unit)
    calm = _calm(fine, values, at)
    if not MOST * calm.size <= calm.sum() < calm.size:
        return None
    runs = [replay for replay, leads in zip(fine.replays, calm, strict=True) if leads]
    leading = Fitter(fitter.predictor, runs, step=FINE, unit=fitter.unit)
    there = leading.residuals(values)
    begun = leading.fit(values, 2 * FURTHER, ENOUGH, at=there)
    if begun.cost > (1.0 - HELD_UP) * float(there @ there):
        return None
    fit = fine.fit(begun.values, FURTHER, ENOUGH)
    # Columns that further rounds reuse are of usual steps.
    return replace(fit, jacobian=fitter.jacobian(fit.values, fit.residuals))


def _calm(fine: Fitter, values: Mapping[str, float], at: np.ndarray) -> np.ndarray:
    """Which runs do what differences foretell of one step of all parameters together (runs,)."""
    columns = fine.jacobian(values, at)
    foretold = []
    moved = dict(values)
    for k, p in enumerate(fine.parameters):
        # To and fro in turn: what all do the same way may cancel.
        to = values[p.name] + (1 if k % 2 else -1) * fine.step * p.typical
        moved[p.name] = min(max(to, p.lower), p.upper)
        foretold.append(columns[:, k] * (moved[p.name] - values[p.name]) / p.typical)
    off = fine.residuals(moved) - at - np.sum(foretold, axis=0)
    run = places(fine.replays)[:, 0]

    def square(rows: np.ndarray) -> np.ndarray:
        return np.bincount(run, rows[: run.size] ** 2, len(fine.replays))

    return square(off) <= ROUGH**2 * np.sum([square(rows) for rows in foretold], axis=0)
