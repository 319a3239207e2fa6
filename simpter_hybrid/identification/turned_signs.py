"""A sign that a map has wrong, told by the runs that show it.

Of all runs together the worst say everything: what a motor did that was driven slowly is off by
friction, whatever the sign of its torque.  So each run is asked, and then a refit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from .channel_factors import (
    SIGN,
    Factors,
    factors_of_quantity,
    judged_like,
    logged,
    quantities,
    with_factors,
)
from .doubted_channels import HALF, LESS, NOTHING, Doubt
from .fitting.fit import WIDE, Fitter
from .fitting.replay import Replay
from .fitting.residual import errors_by_run, rms, weighted_residuals
from .map_changes import Times
from .recordings.recording import Recording
from .rigs.bench import Bench

#: Turned round a sign has to leave less than this of one run's error.
CLEAR = 0.25
#: Iterations of a refit with a sign turned round.
ITERATIONS = 6


def turned_signs(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    parts: Mapping[str, Sequence[Replay]],
    part: str,
    error: float,
) -> tuple[Doubt, ...]:
    """Signs that one run shows to be wrong and none to be right, the best first.

    With the sign turned the model as declared may err more in no run than as it was read, and has
    to err far less in one, there also than with a channel that does nothing.  A refit then has to
    leave less than half of the `error` of the one to what was read.  Or a refit without what drives
    leaves less than half of it, and one with it turned round less still: what drives may do too
    little, but not the contrary.

    Parameters
    ----------
    bench : Bench
    recording : Recording
    values : mapping of str to float
        As declared.
    parts : mapping of str to sequence of Replay
        The runs that ``fit`` and those that ``select``, as they are judged.
    part : str
        Which of them are asked.
    error : float
        What the refitted model leaves of these.
    """
    predictor: Any = bench.predictor

    def made(factors: Factors, of: str) -> list[Replay]:
        changed = bench.made(with_factors(recording, factors), of)
        return [judged_like(a, b, factors) for a, b in zip(parts[of], changed, strict=True)]

    def by_run(replays: Sequence[Replay]) -> np.ndarray:
        return errors_by_run(predictor.predict(values, replays), replays)

    def refit(factors: Factors) -> float:
        """Part of the error that the model leaves, refitted to changed channels."""
        fitter = Fitter(predictor, made(factors, "fit"), step=WIDE)
        refitted = fitter.fit(values, iterations=ITERATIONS).values
        return rms(weighted_residuals(predictor, refitted, made(factors, part))) / error

    read = by_run(parts[part])
    found: list[Doubt] = []
    for names in quantities(recording):
        signs = [f for f in factors_of_quantity(recording, names) if f in SIGN]
        if not signs or any(set(d.change.channels) < set(names) for d in found):
            continue  # of several channels one alone tells as much
        about = dict.fromkeys(names, SIGN[0])
        off = {n: _idle(recording, n) for n in names}
        shown = shows_it(read, by_run(made(about, part)), by_run(made(off, part)))
        drives = all(recording.channels[n].role == "input" for n in names)
        most = HALF if shown else _better_than(refit(off)) if drives else 0.0
        if most > 0.0 and (left := refit(about)) < most:
            found.append(Doubt(Times(logged(recording, names), SIGN[0]), left, part))
    return tuple(sorted(found, key=lambda doubt: doubt.left))


def _better_than(idle: float) -> float:
    """Less than what a turned sign has to leave, where a drive that does nothing leaves `idle`.

    0, which nothing is below, unless that is less than half of what the drive as read leaves.
    """
    return LESS * idle if idle < HALF else 0.0


def shows_it(read: np.ndarray, turned: np.ndarray, idle: np.ndarray) -> bool:
    """Whether one run shows that a sign is wrong, and none that it is right.

    Parameters
    ----------
    read, turned, idle : ndarray (runs,)
        Errors as read, with the sign turned round, and with a channel that does nothing.
    """
    told = read > 0.0  # of a run that is not compared there is no error
    read, turned, idle = read[told], turned[told], idle[told]
    return bool((turned <= read).all() and (turned < CLEAR * np.minimum(read, idle)).any())


def _idle(recording: Recording, name: str) -> float:
    """Factor with which a channel does nothing: of what is measured it is huge."""
    return 1.0 / NOTHING if recording.channels[name].role == "measured" else NOTHING
