"""A residual over one coordinate, bin by bin: an added force and a changed scale."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.stats import t as student

from .trace import Trace

#: Bins of a curve; and of a second one where a coordinate may be `local`: a detent within a
#: fortieth of the way averages out in the former.
BINS, FINE = 12, 48
#: A curve is at one place if a stretch of the coordinate that holds this part of the curve's
#: squares is no longer than this part of the coordinate.
MOST, SHORT = 0.8, 0.25
#: Fewest learned samples in a bin.
FEWEST = 8
#: Bins of a coordinate's beginning grow by this factor.  Own backlash of 4 to 10 mrad fills a
#: hundredth of the samples: bins of equally many took away 2 to 7 % of the mean square, these 18 to
#: 36 %.
GROWTH = 2.0


def learned_curve(traces: Sequence[Trace], name: str, bins: int = BINS):
    """Quantile bins, finer where a coordinate begins; in each the least-squares a + b*torque."""
    x = np.concatenate([t.coordinates[name] for t in traces])
    y = np.concatenate([t.residual for t in traces])
    torque = np.concatenate([t.torque for t in traces])
    edges = _edges(x, bins)
    if name in traces[0].begins:
        edges = np.unique([*_beginning(x, edges, traces[0].begins[name]), *edges])
    place = np.searchsorted(edges, x, side="right")
    ridge = 1e-3 * (float(torque @ torque) / torque.size + 1e-30)
    centres, curve = [], []
    for k in range(edges.size + 1):
        chosen = place == k
        t, r = torque[chosen], y[chosen]
        n = max(t.size, 1)
        normal = np.array([[n, t.sum()], [t.sum(), t @ t + n * ridge]])
        curve.append(np.linalg.solve(normal, [r.sum(), t @ r]))
        centres.append(float(np.median(x[chosen])) if t.size else np.nan)
    return edges, np.array(centres), np.array(curve)


def usual_torque(traces: Sequence[Trace]) -> float:
    """Root mean square of the torque or force that passes the friction; 1 where none does."""
    torque = np.concatenate([t.torque for t in traces])
    return float(np.sqrt(torque @ torque / max(torque.size, 1))) or 1.0


def curve_band(traces: Sequence[Trace], name: str, edges: np.ndarray, at: float) -> np.ndarray:
    """Half-width of a 95 % band of the curve where `at` is passed on (bins,), by runs left out.

    By Student's t: the error is estimated from as few values as there are runs.
    What differs from run to run is in it, and no noise has to be white; NaN of one run alone.
    """
    sums = np.array([_sums(t.coordinates[name], t.torque, t.residual, edges) for t in traces])
    torque = np.concatenate([t.torque for t in traces])
    ridge = 1e-3 * (float(torque @ torque) / torque.size + 1e-30)
    count = len(traces)
    if count < 2:
        return np.full(edges.size + 1, np.nan)
    values = np.empty((count, edges.size + 1))
    for i, rest in enumerate(sums.sum(axis=0) - sums):
        n, t, tt, r, tr = rest.T
        normal = np.moveaxis(np.array([[np.maximum(n, 1), t], [t, tt + np.maximum(n, 1) * ridge]]),
                             2, 0)  # fmt: skip
        added, scaled = np.linalg.solve(normal, np.column_stack([r, tr])[..., None])[..., 0].T
        values[i] = added + at * scaled
    error = np.sqrt((count - 1) / count * np.sum((values - values.mean(axis=0)) ** 2, axis=0))
    return float(student.ppf(0.975, count - 1)) * error


def _sums(x: np.ndarray, torque: np.ndarray, residual: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Sums over each bin of one run: samples, torque, its square, residual and their product."""
    place, size = np.searchsorted(edges, x, side="right"), edges.size + 1
    weights = (np.ones(x.size), torque, torque**2, residual, torque * residual)
    return np.column_stack([np.bincount(place, w, size) for w in weights])


def stretch(traces: Sequence[Trace], name: str) -> tuple[float, float] | None:
    """Shortest stretch of a coordinate that holds `MOST` of a residual's curve, and as much beside.

    None where that is no short one (`SHORT`).
    """
    edges, _, curve = learned_curve(traces, name, FINE)
    x = np.concatenate([t.coordinates[name] for t in traces])
    torque = np.concatenate([t.torque for t in traces])
    square = on_curve(edges, curve, x, torque) ** 2
    order = np.argsort(x)
    x, held = x[order], np.cumsum(square[order])
    first = np.arange(x.size)
    last = np.searchsorted(held, np.concatenate([[0.0], held[:-1]]) + MOST * held[-1])
    first, last = first[last < x.size], last[last < x.size]
    if first.size == 0:
        return None
    shortest = int(np.argmin(x[last] - x[first]))
    low, high = float(x[first[shortest]]), float(x[last[shortest]])
    wide = high - low
    if not 0.0 < wide <= SHORT * float(np.ptp(x)):
        return None
    return low - 0.5 * wide, high + 0.5 * wide


def _edges(x: np.ndarray, most: int) -> np.ndarray:
    """Edges of bins of equally many samples, or between values that are few (a direction)."""
    bins = max(2, min(most, x.size // FEWEST))
    values = np.unique(x)
    if values.size <= max(bins, 3):
        return (values[1:] + values[:-1]) / 2
    return np.unique(np.quantile(x, np.linspace(0, 1, bins + 1)))[1:-1]


def _beginning(x: np.ndarray, edges: np.ndarray, resolved: float) -> list[float]:
    """Edges below the first of `edges`, down to what can be told from 0; no bin is nearly empty."""
    found: list[float] = []
    above = edge = float(edges[0]) if edges.size else 0.0
    while edge >= GROWTH * resolved > 0.0:
        edge /= GROWTH
        if min(np.sum(x < edge), np.sum((x >= edge) & (x < above))) >= FEWEST:
            found.append(edge)
            above = edge
    return found


def on_curve(edges, curve, x, torque):
    """The curve's value at each `x` (samples,): a level, and a part of the torque, a bin."""
    place = np.searchsorted(edges, x, side="right")
    return curve[place, 0] + curve[place, 1] * torque
