"""A search does not wait for a candidate whose steps are far shorter than its rows."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis

from simpter_hybrid.effects.drive_lag import DriveLag
from simpter_hybrid.identification.rigs import scenario_runner
from simpter_hybrid.identification.rigs.scenario_runner import GivenRun, ScenarioRunner

GRID = np.linspace(0.01, 0.5, 50)


@pytest.mark.parametrize(("lag", "ends"), [(1e-3, True), (1e-8, False)])
def test_it_has_failed_after_so_many_steps(monkeypatch, lag, ends):
    monkeypatch.setattr(scenario_runner, "MOST_STEPS", 20_000)
    monkeypatch.setattr(scenario_runner, "STEPS_A_ROW", 10)
    slow = DriveLag(coordinate=0, lag=lag, constant=1.0)
    runner = ScenarioRunner(replace(declared_axis(), effects=(slow,), t_end=0.5))
    rows, steps = runner.run(GivenRun(runner.default, np.array([0.0, -1.0]), np.zeros(1), GRID))
    assert np.isfinite(rows[-1]).all() == ends
    assert steps <= 20_000
