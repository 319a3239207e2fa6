"""A fitted run that is unlike the others rules a refit: a hand that touched it is no effect."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from .doubted_channels import HALF
from .fitting.fit import WIDE, Fitter
from .fitting.fitted_model import Split
from .fitting.residual import errors_by_experiment, errors_by_run
from .tracing.limits import IMPERFECT
from .tracing.rounds import SearchResult

#: Fewest fitted runs of which one may rule, and how many with the largest errors are left out,
#: one at a time.
FEWEST, TRIED = 3, 4
#: Iterations of a fit.
ITERATIONS = 8


class RulingRun(NamedTuple):
    """A fitted run without which the declared model predicts the selecting runs far better.

    Parameters
    ----------
    name : str
    left : float
        Part of the refitted model's error on the selecting runs that is left by a refit without it.
    """

    name: str
    left: float


def ruling_run(done: SearchResult, split: Split, least: float) -> RulingRun | None:
    """The fitted run that a refit had better do without, if there is one.

    It leaves less than half of the refitted model's error on the selecting runs then, and of what
    it leaves without any other run, and about as little as with all effects that were found.  Asked
    only where the refitted model leaves more than the error `least`, and no effect explains that
    plainly.
    """
    model, runs = done.refitted, list(split.fit)
    asked = done.verdict.kind != "effect" and model.select_error > least and len(runs) >= FEWEST
    if not asked:
        return None
    predictor: Any = model.predictor
    errors = errors_by_run(predictor.predict(model.values, runs), runs)
    begin = {p.name: p.value for p in predictor.parameters}
    found = []
    for k in np.argsort(-errors, kind="stable")[:TRIED].tolist():
        others = [*runs[:k], *runs[k + 1 :]]
        fitter = Fitter(predictor, others, step=WIDE, unit=model.unit)
        values = fitter.fit(begin, iterations=ITERATIONS).values
        error, _ = errors_by_experiment(predictor, values, split.select)
        found.append(RulingRun(runs[k].name, error / model.select_error))
    best, second, *_ = sorted(found, key=lambda one: one.left)
    most = min(HALF, IMPERFECT * done.corrected.select_error / model.select_error)
    return best if best.left < min(most, HALF * second.left) else None
