"""A brake that one run holds and another works is asked about in both."""

import numpy as np
import pytest
from axis_recordings import MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.traces import AxisTracer
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.tracing.signature import dependences

TIME = 0.004 * np.arange(500)
STAIRS = 2.0 + np.floor(2.0 * TIME)


def _run(press):
    drive, nothing = 0.9 * np.sin(4.0 * TIME), np.zeros(TIME.size)
    position, speed = 0.2 * np.sin(4.0 * TIME), 0.8 * np.cos(4.0 * TIME)
    inputs = {"drive": drive, "released": nothing, "holds": nothing}
    inputs |= {"press": press, "press holds": nothing}
    seen = {"position": Observation(position, 1e-3, np.ones(TIME.size, bool))}
    notes = {"start": np.array([0.0, 0.8]), "position": position, "speed": speed}
    return Replay("run", "run", TIME, inputs, seen, notes=notes)


@pytest.mark.parametrize("pressed", [True, False])
def test_whichever_run_is_the_first(pressed):
    predictor = ScenarioPredictor(parse(MODEL), AxisRig())
    values = {p.name: p.value for p in predictor.parameters}
    tracer = AxisTracer(0.02, pressed=pressed)
    held, worked = (tracer(predictor, values, [_run(p)])["force"] for p in (0 * TIME + 5.0, STAIRS))
    for runs in ((held, worked), (worked, held)):
        asked = {one.coordinate for one in dependences(*runs)}
        assert ("excitation" in asked) == pressed
