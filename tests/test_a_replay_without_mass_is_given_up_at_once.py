"""A fit may take more inertia off than there is: such a run would never end."""

from dataclasses import replace

import numpy as np
from axis_recordings import MODEL

from simpter_hybrid.effects.added_inertia import AddedInertia
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.rigs.scenario_runner import GivenRun, ScenarioRunner

GRID = np.linspace(0.1, 0.5, 5)


def test_no_number_is_told_of_it():
    declared = replace(parse(MODEL), controllers=(), loads=(), period=0.0)
    inertia = declared.device.parameters()["inertia"]
    lighter = AddedInertia(coordinate=0, inertia_change=0.0)
    runner = ScenarioRunner(replace(declared, effects=(lighter,)))
    own = next(k for name, k in runner.names.items() if name.endswith("inertia_change"))
    for part, runs in ((-0.9, True), (-1.1, False)):
        parameters = runner.default.copy()
        parameters[own] = part * inertia
        rows, steps = runner.run(
            GivenRun(parameters, np.array([0.0, -1.0]), np.zeros(1), GRID, start=[0, 1])
        )
        assert np.isfinite(rows).all() == runs
        assert bool(steps) == runs
