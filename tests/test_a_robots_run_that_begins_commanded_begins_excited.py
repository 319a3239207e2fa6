"""A run of a robot may be cut while clutches are on: its first commands have acted before it."""

import numpy as np
from robot_replays import declared, replay

from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.tip.rig import TipRig


def test_coils_begin_at_the_first_rows_commands():
    predictor = ScenarioPredictor(declared(), TipRig())
    told = predictor.predict({p.name: p.value for p in predictor.parameters}, [replay()])
    seen = [told[f"excitation_{i + 1}"][0] for i in range(4)]
    for excitation, volts in zip(seen, (2.0, 2.0, 0.0, 0.0), strict=True):
        np.testing.assert_array_equal(excitation, volts)
