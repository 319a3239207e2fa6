"""A stop ends a run of the model's own; a recorded run that goes past it is replayed to its end."""

from dataclasses import replace

import numpy as np
from axis_recordings import declared_axis

from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.stop import CoordinateLimit


def test_the_replay_is_the_same_as_without_it():
    time = 0.01 * np.arange(100)
    inputs = {
        "drive": np.full(time.size, 1.0), "press": np.zeros(time.size),
        "released": np.zeros(time.size), "holds": np.ones(time.size),
    }  # fmt: skip
    run = Replay("r", "r", time, inputs, {}, notes={"start": np.zeros(2)})
    free = declared_axis()
    stopped = replace(free, stops=(CoordinateLimit(limit=0.05),))
    told = [
        ScenarioPredictor(each, AxisRig()).predict({"Coulomb friction": 1.0}, [run])["position"][0]
        for each in (free, stopped)
    ]
    assert told[0].max() > 0.05
    np.testing.assert_array_equal(*told)
