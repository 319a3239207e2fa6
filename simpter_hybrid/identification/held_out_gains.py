"""What a round's best candidates take off the error of the runs held out, with intervals.

No choice is made by it: it is computed when all is decided, for the reader.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.stats import bootstrap

from .fitting.predictor import Predictor
from .fitting.replay import Replay
from .fitting.residual import residual_parts
from .tracing.rounds import Diagnosis

#: Candidates of a round that are asked, the best on the selecting runs first: the rest lie below.
ASKED = 8
#: A run's channel is cut into so many blocks, each longer than most noise lasts.
BLOCKS = 10
RESAMPLES, LEVEL, SEED = 999, 0.95, 1


class HeldOutGain(NamedTuple):
    """Relative fall of the error by one candidate on the runs held out, with its 95 % interval."""

    name: str
    gain: float
    low: float
    high: float


def held_out_gains(
    done: Diagnosis, replays: Sequence[Replay]
) -> tuple[tuple[HeldOutGain, ...], ...]:
    """For each round, what its candidates take off the error of these runs.

    Parameters
    ----------
    done : Diagnosis
    replays : sequence of Replay
        Runs that had no part in it.
    """
    found = []
    for one in done.rounds:
        assert one.base is not None
        base = _squares(one.base.predictor, one.base.values, replays)
        gains = []
        for trial in one.trials[:ASKED]:
            with_it = one.base.predictor.extended(trial.candidate)
            after = _squares(with_it, trial.fit.values, replays)
            gains.append(HeldOutGain(trial.candidate.name, *_gain(base, after)))
        found.append(tuple(gains))
    return tuple(found)


def _squares(
    predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
) -> np.ndarray:
    """Sums of squares of the weighted residuals, block after block (blocks,)."""
    parts = residual_parts(predictor.predict(values, replays), replays)
    blocks = (np.array_split(p, min(BLOCKS, p.size)) for _, _, p in parts if p.size)
    return np.array([float(b @ b) for of in blocks for b in of])


def _gain(before: np.ndarray, after: np.ndarray) -> tuple[float, float, float]:
    """Relative fall of the root mean square; blocks are drawn in pairs."""

    def fall(b: np.ndarray, a: np.ndarray, axis: int = -1) -> np.ndarray:
        return 1.0 - np.sqrt(a.sum(axis=axis) / b.sum(axis=axis))

    found = float(fall(before, after))
    if before.size < 2 or np.array_equal(before, after):
        return found, found, found
    drawn = bootstrap(
        (before, after), fall, paired=True, n_resamples=RESAMPLES, confidence_level=LEVEL,
        method="percentile", rng=np.random.default_rng(SEED),
    )  # fmt: skip
    ends = drawn.confidence_interval
    return found, float(ends.low), float(ends.high)
