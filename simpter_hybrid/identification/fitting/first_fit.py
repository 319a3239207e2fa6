"""A rough first fit of declared parameters that looks beyond the valley in which it begins."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from .fit import WIDE, Fit, Fitter
from .floor import merged
from .predictor import Predictor
from .replay import Replay, in_windows

#: Iterations, and the part of the sum of squares that ends them.
ITERATIONS, ENOUGH = 4, 3e-3
#: Where each declared parameter is looked for beside where it ended, in its tolerances.
ROUND_ABOUT = (-2.5, -1.0, 1.0, 2.5)


def first_fit(predictor: Predictor, replays: Sequence[Replay], nominal: Mapping[str, float]) -> Fit:
    """Declared parameters, fitted roughly; of runs followed whole also from a fit in windows.

    Where the fit has ended each parameter is looked for elsewhere within its tolerance, and if that
    leaves less the fit goes on from there: events move in steps, and between two of them no slope
    leads on.  A level of breakaway that a ramp does not reach any more costs nothing until it is
    one that is reached too soon.

    Parameters
    ----------
    predictor : Predictor
    replays : sequence of Replay
    nominal : mapping of str to float
        Declared values [SI].
    """

    def fitter(runs: Sequence[Replay]) -> Fitter:
        return Fitter(predictor, merged(runs), step=WIDE)

    starts = [nominal]
    if any(r.followed for r in replays):
        cut = fitter([in_windows(replay) for replay in replays])
        starts.append(cut.fit(nominal, ITERATIONS, ENOUGH).values)
    every = fitter(replays)
    fits = [every.fit(start, ITERATIONS, ENOUGH) for start in starts]
    return _looked_round(every, min(fits, key=lambda fit: fit.cost))


def _looked_round(fitter: Fitter, fit: Fit) -> Fit:
    values, at, cost = fit.values, fit.residuals, fit.cost
    for p in fitter.declared:
        for times in ROUND_ABOUT:
            there = min(max(p.value + times * p.tolerance, p.lower), p.upper)
            residuals = fitter.residuals({**values, p.name: there})
            if (new := float(residuals @ residuals)) < cost:
                values, at, cost = {**values, p.name: there}, residuals, new
    if cost == fit.cost:
        return fit
    return fitter.fit(values, ITERATIONS, ENOUGH, at=at)
