"""What a pause takes of steps is not taken from the rows behind it."""

from dataclasses import replace

import numpy as np
from axis_recordings import declared_axis

from simpter_hybrid.identification.rigs import scenario_runner
from simpter_hybrid.identification.rigs.scenario_runner import GivenRun, ScenarioRunner

GRID = np.concatenate([np.linspace(0.01, 0.5, 50), 20.0 + np.linspace(0.01, 0.5, 50)])
PERIOD = 1e-3


def test_rows_behind_a_pause_are_simulated(monkeypatch):
    monkeypatch.setattr(scenario_runner, "MOST_STEPS", 2_000)
    runner = ScenarioRunner(replace(declared_axis(), period=PERIOD))
    still = np.array([0.0, -1.0])
    rows, steps = runner.run(GivenRun(runner.default, still, np.zeros(1), GRID, period=PERIOD))
    assert steps > 10_000  # more than rows alone may take
    assert np.isfinite(rows).all()
