"""A flywheel runs down for minutes, logged once a second: a replay need not step every 20 ms."""

from dataclasses import replace

import numpy as np
from axis_recordings import MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.rigs.scenario_runner import GivenRun, ScenarioRunner

INERTIA, COULOMB, VISCOUS, BEGINS = 10.0, 0.2, 0.02, 10.0
FADE = VISCOUS / INERTIA
RESTS = np.log1p(BEGINS * VISCOUS / COULOMB) / FADE
GRID = np.arange(1.0, 600.0)


def test_a_step_goes_a_whole_row_and_speeds_are_those_of_the_closed_form():
    text = MODEL.replace("0.02 kg*m^2", f"{INERTIA} kg*m^2").replace('weight = "0.5 N*m"\n', "")
    declared = replace(parse(text), controllers=(), loads=(), period=0.0)
    runner = ScenarioRunner(declared)
    none = np.zeros(1)
    switching, start = np.array([0.0, -1.0]), [0.0, BEGINS]
    rows, steps = runner.run(GivenRun(runner.default, switching, none, GRID, start=start))
    at_rest = BEGINS + COULOMB / VISCOUS
    closed = np.maximum(at_rest * np.exp(-FADE * GRID) - COULOMB / VISCOUS, 0.0)
    assert GRID[0] < RESTS < GRID[-1]
    # Tolerances of 1e-10 a step and 1e-12 rad/s, 600 steps.
    assert np.max(np.abs(rows[:, 1] - closed)) < 1e-7
    assert steps < 1.5 * GRID.size
