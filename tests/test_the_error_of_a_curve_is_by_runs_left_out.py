"""Two routes to one number: the band of a residual's curve against curves of many recordings."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import t as student

from simpter_hybrid.identification.tracing.curve import curve_band, learned_curve
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
        told.append(curve_band(traces, "x", edges, 1.0))
        place = [np.searchsorted(edges, t.coordinates["x"]) for t in traces]
        mean = [np.concatenate([t.residual[p == k] for t, p in zip(traces, place, strict=True)])
                for k in range(edges.size + 1)]  # fmt: skip
        curves.append([m.mean() for m in mean])
    # 60 recordings tell a standard deviation to 9 %, and there are four bins.
    half = student.ppf(0.975, RUNS - 1) * np.std(curves, axis=0)
    assert np.mean(told, axis=0) == pytest.approx(half, rel=0.3)


@pytest.mark.parametrize("count", [2, 4])
def test_a_band_of_few_runs_holds_the_truth_as_often_as_it_says(count):
    draw, inside = np.random.default_rng(3), []
    for _ in range(300):
        runs = _traces(draw, count)
        traces = [replace(r, residual=r.residual + draw.standard_normal()) for r in runs]
        edges, _, curve = learned_curve(traces, "x", 4)
        inside.append(np.abs(curve.sum(axis=1)) < curve_band(traces, "x", edges, 1.0))
    # Of 300 recordings whose bins are hardly independent 0.95 is told to 1.3 %: three times that.
    assert np.mean(inside) == pytest.approx(0.95, abs=0.04)


def test_of_one_run_none_is_known():
    trace = _traces(np.random.default_rng(2), 1)
    edges, _, _ = learned_curve(trace, "x", 4)
    assert np.isnan(curve_band(trace, "x", edges, 1.0)).all()
