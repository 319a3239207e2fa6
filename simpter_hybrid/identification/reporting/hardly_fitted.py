"""What the selecting runs show and the fitted ones hardly do: no fit can find its size."""

from __future__ import annotations

from ..fitting.residual import rms
from ..fitting.search import HOPEFUL
from ..result import Diagnosis
from ..tracing.rivals import LEAST_GAIN
from ..tracing.verdict import LACKING
from .one_run import alone_when

#: The fitted runs hardly show a lack if theirs is no more than this part of that of the selecting
#: runs (mean squares above the floor) ...
HARDLY = 0.1
#: ... and this is said only where the error of the selecting runs is so many times the floor, and
#: that of the fitted ones is not.
LACK = 2.0
#: Experiments with this part of the largest error are named.
MOST = 0.5


def hardly_fitted_sentence(found: Diagnosis) -> str:
    """Which runs should be fitted as well, and what would help there; "" where fits can tell."""
    done = found.search
    fitted = rms(done.refitted.residuals) / found.floors.fit
    ratio = done.refitted.select_error / done.floor
    shown = fitted**2 - 1.0 > HARDLY * (ratio**2 - 1.0)
    if done.verdict.kind not in LACKING or ratio < LACK or fitted >= LACK or shown:
        return ""
    errors = done.refitted.by_experiment
    named = [n for n, e in errors.items() if e >= MOST * max(errors.values())]
    where = f" ({', '.join(named)})" if named else ""
    ask = (
        f"let some runs of the kind{where} fit as well, unless something else acted in these alone "
        "(a hand, a stop)"
    )
    if alone := alone_when(found):
        ask = (
            f"of these one alone leaves more than noise ({alone}). If nothing else acted there (a "
            "hand, a stop, a sensor that slipped), let a run like it fit as well"
        )
    said = (
        f"The fitted runs hardly show it ({fitted:.2f} times the floor, {ratio:.2f} times on those "
        f"that select), so no size can be fitted: {ask}."
    )
    untold = [
        t for t in done.rounds[0].trials
        if t.gain >= LEAST_GAIN and t.fit.cost >= (1 - 2 * HOPEFUL) * done.refitted.cost
    ]  # fmt: skip
    if not untold:
        return said
    best = max(untold, key=lambda t: t.gain)
    return (
        f"{said} There {best.candidate.listed_as}, of a size that nothing has fitted, lowers the "
        f"error by {100 * best.gain:.0f} %."
    )
