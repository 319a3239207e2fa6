"""A brake that is switched at a row is on from there, and has been before a run as it begins."""

import numpy as np
import pytest
from axis_recordings import MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.held_inputs import HOLDS
from simpter_hybrid.identification.axis.prescribed_rig import PrescribedRig
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor

TIME = 0.01 * np.arange(6)
PRESS = np.array([2.0, 2.0, 2.0, 0.0, 0.0, 0.0])


def _run(held):
    nothing = np.zeros(TIME.size)
    inputs = dict.fromkeys(("drive", "released", "holds"), nothing)
    inputs |= {"press": PRESS, "press holds": np.full(TIME.size, HOLDS[held])}
    return Replay("run", "run", TIME, inputs, {}, notes={"start": np.zeros(2)})


@pytest.mark.parametrize("rig", [AxisRig(), PrescribedRig()])
@pytest.mark.parametrize(("held", "off"), [("after", 0.03), ("before", 0.02), ("sampled", 0.025)])
def test_it_is_switched_off_where_it_was(rig, held, off):
    period = 1e-3
    rows = rig.pack(_run(held), period)[3:].reshape(-1, 3)
    middle = (np.arange(len(rows)) + 0.5) * period
    assert np.interp(-1.0, -rows[:, 0], middle) == pytest.approx(off, abs=period)


@pytest.mark.parametrize("rig", [AxisRig(), PrescribedRig()])
def test_a_run_begins_as_if_pressed_for_long(rig):
    assert rig.excited(_run("after")) == 2.0


def test_the_model_begins_with_it():
    declared = parse(MODEL)
    rig = AxisRig()
    predictor = ScenarioPredictor(declared, rig)
    values = {p.name: p.value for p in predictor.parameters}
    excitation = predictor.predict(values, [_run("after")])["excitation"][0]
    assert excitation[0] == 2.0
