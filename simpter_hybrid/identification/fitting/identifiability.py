"""What an experiment can see, is blind to, and confuses; how sure fitted values are.

An effect's *signal* is the change of all predicted channels, in standard deviations, when the
effect acts at its typical size, less what the declared parameters could imitate.  It is computed
by simulation at full size, not from a derivative: the information often sits in event times.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import t as student

from ..recordings.projection import beyond
from .fit import Fit
from .predictor import Parameter
from .replay import Replay
from .residual import places

#: Blocks of a run over which residuals of all its channels may be correlated, in rows; where there
#: are few rows shorter ones, so many for each parameter: scores of fewer blocks than parameters are
#: of no full rank, and those of one block add up to nothing at an optimum.
BLOCK, BLOCKS = 250, 10
#: Signals of which this part is imitated by the other effect cannot be told apart.
ALIKE = 0.9
#: An effect whose typical size would raise the error by less than this goes unseen.
VISIBLE = 0.02


@dataclass(frozen=True)
class Estimate:
    """A fitted value with the half-width of its 95 % interval [SI]; inf: not shown by the data."""

    name: str
    value: float
    half_width: float
    unit: str


def estimates(
    parameters: Sequence[Parameter], fit: Fit, replays: Sequence[Replay]
) -> tuple[tuple[Estimate, ...], np.ndarray]:
    """Values with 95 % intervals, and the correlations of the estimates (parameters, parameters).

    The covariance is the sandwich over blocks of residuals, so coloured noise and an imperfect
    form widen the intervals as they should (Student's t, as many degrees of freedom as blocks less
    parameters).  A declared tolerance counts as what it says, not as how far the fit went: data
    that hardly show a parameter leave it as it was declared, and no surer.  Of what these data do
    not show at all intervals are infinite.  `replays`: those fitted.
    """
    columns, residuals = fit.jacobian, fit.residuals
    bread = np.linalg.pinv(columns.T @ columns)
    told = residuals.size - sum(np.isfinite(p.tolerance) for p in parameters)
    block = _blocks(places(replays), BLOCKS * len(parameters))
    count = int(block.max(initial=0)) + 1
    scores = np.zeros((count, len(parameters)))
    np.add.at(scores, block, columns[:told] * residuals[:told, None])
    freedom = max(1, count - len(parameters))
    held = fit.unit * columns[told:]
    spread = scores.T @ scores * (count / freedom) + held.T @ held
    covariance = bread @ spread @ bread
    reach = float(student.ppf(0.975, freedom))
    deviation = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    shown = np.abs(columns[:told]).max(axis=0) > 0.0
    size = np.array([p.typical for p in parameters])
    found = tuple(
        Estimate(p.name, fit.values[p.name], float(reach * d * s) if seen else np.inf, p.unit)
        for p, d, s, seen in zip(parameters, deviation, size, shown, strict=True)
    )
    scale = np.where(deviation > 0, deviation, 1.0)
    return found, covariance / np.outer(scale, scale)


def widest(one: Sequence[Estimate], other: Sequence[Estimate]) -> tuple[Estimate, ...]:
    """Less sure estimate of each parameter, of two where both say how sure they are."""
    return tuple(
        b if a.half_width < b.half_width < np.inf else a for a, b in zip(one, other, strict=True)
    )


def _blocks(places: np.ndarray, most: int) -> np.ndarray:
    """Block of every compared value, from 0: some rows of a run, with all its channels."""
    runs, rows = places.T
    stride = rows.max(initial=0) + 1
    every, of = np.unique(runs * stride + rows, return_inverse=True)
    first = np.searchsorted(every, np.arange(runs.max(initial=0) + 1) * stride)
    run = every // stride
    length = min(BLOCK, max(1, every.size // most))
    within = (np.arange(every.size) - first[run]) // length
    return np.unique(run * (every.size + 1) + within, return_inverse=True)[1][of]


def visibility(change: np.ndarray) -> float:
    """Relative rise of the error that the signal causes over unit noise."""
    return float(np.sqrt(1.0 + change @ change / change.size) - 1.0)


def least_visible(count: int) -> float:
    """Size of a signal that raises the error of so many residuals by `VISIBLE`."""
    return float(np.sqrt(((1.0 + VISIBLE) ** 2 - 1.0) * count))


def blind_to(signals: Mapping[str, np.ndarray]) -> tuple[str, ...]:
    """Effects that these experiments would not show at their typical size."""
    return tuple(name for name, change in signals.items() if visibility(change) < VISIBLE)


def confused(signals: Mapping[str, np.ndarray]) -> tuple[tuple[str, str, float], ...]:
    """Pairs that can be seen but not told apart, with the part imitated, largest first."""
    seen = [name for name in signals if visibility(signals[name]) >= VISIBLE]
    if not seen:
        return ()
    every = np.array([signals[name] for name in seen])
    products = every @ every.T
    powers = np.diag(products)
    parts = products**2 / np.outer(powers, powers)
    pairs = [
        (a, seen[j], float(parts[i, j]))
        for i, a in enumerate(seen)
        for j in range(i + 1, len(seen))
        if parts[i, j] >= ALIKE
    ]
    return tuple(sorted(pairs, key=lambda p: -p[2]))


def separation(
    one: np.ndarray, other: np.ndarray, owner: np.ndarray, experiments: Sequence[str]
) -> dict[str, float]:
    """How far apart each experiment would hold two effects, in standard deviations.

    Parameters
    ----------
    one, other : ndarray (N,)
        Signals of the two effects over the experiments that might be run.
    owner : ndarray of int (N,)
        Index into `experiments` of each residual.
    experiments : sequence of str

    Returns
    -------
    dict
        Experiment -> distance between the first effect and the best imitation of it by the other,
        the imitation being fitted in that experiment alone.
    """
    found = {}
    for k, name in enumerate(experiments):
        here = owner == k
        found[name] = float(np.linalg.norm(beyond(one[here], other[here][:, None])))
    return dict(sorted(found.items(), key=lambda item: -item[1]))
