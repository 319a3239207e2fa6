"""The verdict on one round, shown as little as a test needs."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Trial, share
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.tracing.limits import REPEATED
from simpter_hybrid.identification.tracing.rivals import LEAST_GAIN
from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.identification.tracing.verdict import Evidence, Verdict, judge

#: Error of the refitted model, and of a perfect one.
BEFORE, FLOOR = 1.5, 1.0


def judged(
    trials: Sequence, before: Sequence, after: Sequence, floor: float, **given: Any
) -> Verdict:
    """Of a first round at the floor of repeated runs that go both ways, unless `given` says."""
    usual = {
        "ratio": 1.0, "limit": REPEATED, "least": LEAST_GAIN, "one_way": False, "found": (),
        "mistakable": {},
    }  # fmt: skip
    return judge(Evidence(trials, before, after, floor, **{**usual, **given}))


def trial(name, select, family=None, coordinates=("x",), parameters=1):
    """A candidate that leaves `select` on the selecting runs."""
    own = tuple(Parameter(f"p{k}", 0.0, -1.0, 1.0, 0.1) for k in range(parameters))
    candidate = Candidate(
        name, own, ((0.0,) * parameters,), family or name, "friction", coordinates
    )
    fit = Fit({}, 0.0, np.empty((0, 0)), np.empty(0))
    return Trial(candidate, fit, select, 1 - select / BEFORE, share(BEFORE, select, FLOOR))


def depends(name, gain, p_value=0.005):
    """A dependence of a thousand samples."""
    nothing = np.empty(0)
    return Dependence(name, gain, p_value, 1000, nothing, nothing, nothing)
