"""Figure 37: the path reaches its stop line, where the run ends between two instants of a grid."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.known_units import INCH
from simpter_hybrid.reproduce import baseline


@pytest.mark.parametrize(("speed", "verdict"), [(-0.5, "holds"), (-0.45, "does not hold")])
def test_the_end_of_a_run_counts(monkeypatch, speed, verdict):
    def taken(run, times):
        tip = np.array([[3.0 + 62.0 * speed * t, 24.0] for t in times]) * INCH
        return SimpleNamespace(tip=tip, slip=np.zeros((1, 4)))

    counted = SimpleNamespace(flat=((), (), (), ()))
    monkeypatch.setattr(baseline, "sample", taken)
    run = SimpleNamespace(t_end=1.0 + 1e-9, scenario=SimpleNamespace(period=1.0 / 150.0))
    monkeypatch.setattr(baseline, "standard", lambda *_: run)
    monkeypatch.setattr(baseline, "transitions", lambda run: counted)
    monkeypatch.setattr(baseline, "flat", lambda *_: [])
    monkeypatch.setattr(baseline, "jerk_rows", lambda *_: [])
    row = baseline.baseline(lambda scenario: None)[0]
    assert row.item == "A31"
    assert row.verdict == verdict
