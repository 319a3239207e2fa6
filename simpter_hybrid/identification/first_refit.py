"""Declared parameters fitted roughly, before anything is weighed or searched."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from .fitting.farther import best_along
from .fitting.fit import WIDE, Fit, Fitter
from .fitting.predictor import Parameter
from .fitting.replay import Replay, in_windows
from .fitting.replicates import merged

#: Of a number with such a relative tolerance other values are begun from, in tolerances.
HARDLY, PARTS = 0.3, (-1.0, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0)


def first_refit(predictor: Any, replays: Sequence[Replay], nominal: Mapping[str, float]) -> Fit:
    """Declared parameters, fitted roughly; of runs followed whole also from a fit in windows.

    Of numbers that are hardly known also from the best of other values within their tolerances: a
    stiffness of twice the true one lies in another valley than that.
    """

    def fitted(runs: Sequence[Replay], start: Mapping[str, float]) -> Fit:
        fitter = Fitter(predictor, merged(runs), step=WIDE)
        return fitter.fit(start, iterations=4, enough=3e-3)

    starts = [nominal]
    if any(r.followed for r in replays):
        starts.append(fitted([in_windows(replay) for replay in replays], nominal).values)
    if hardly := [p for p in predictor.parameters if _hardly_known(p)]:
        fitter = Fitter(predictor, merged(replays), step=WIDE)
        at = fitter.residuals(nominal)
        starts.append(best_along(fitter, nominal, at, hardly, _within_tolerance)[0])
    return min((fitted(replays, start) for start in starts), key=lambda fit: fit.cost)


def _hardly_known(p: Parameter) -> bool:
    return p.value != 0.0 and HARDLY <= p.tolerance / abs(p.value) < np.inf


def _within_tolerance(p: Parameter, value: float) -> list[float]:
    tried = (p.value + part * p.tolerance for part in PARTS)
    return [x for x in tried if p.lower <= x <= p.upper and x != value]
