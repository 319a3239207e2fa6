"""Two routes to one number: the band of a residual's curve against curves of many recordings."""

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.curve import curve_error, learned_curve
from simpter_hybrid.identification.tracing.trace import Trace

RUNS, SAMPLES = 12, 300


def _traces(draw, count=RUNS):
    """A residual that depends on nothing, with noise that stays for 20 samples."""
    found = []
    for _ in range(count):
        x = draw.uniform(-1.0, 1.0, SAMPLES)
        slow = np.repeat(draw.standard_normal(SAMPLES // 20), 20)
        found.append(Trace(slow, np.ones(SAMPLES), {"x": np.sort(x)}))
    return found


def test_it_is_what_curves_of_other_recordings_scatter_by():
    draw = np.random.default_rng(1)
    edges, _, _ = learned_curve(_traces(draw), "x", 4)
    told, curves = [], []
    for _ in range(60):
        traces = _traces(draw)
        told.append(curve_error(traces, "x", edges, 1.0))
        place = [np.searchsorted(edges, t.coordinates["x"]) for t in traces]
        mean = [np.concatenate([t.residual[p == k] for t, p in zip(traces, place, strict=True)])
                for k in range(edges.size + 1)]  # fmt: skip
        curves.append([m.mean() for m in mean])
    # 60 recordings tell a standard deviation to 9 %, and there are four bins.
    assert np.mean(told, axis=0) == pytest.approx(np.std(curves, axis=0), rel=0.3)


def test_of_one_run_none_is_known():
    trace = _traces(np.random.default_rng(2), 1)
    edges, _, _ = learned_curve(trace, "x", 4)
    assert np.isnan(curve_error(trace, "x", edges, 1.0)).all()
