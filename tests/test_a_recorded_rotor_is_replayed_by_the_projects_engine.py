"""Two routes to one run: the reference engine with a servo, the compiled replay of its record."""

import numpy as np
import pytest

from simpter_hybrid.api import run
from simpter_hybrid.files.scenario_file import load, parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.corrected import corrected_scenario
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rotor.rig import RotorRig
from simpter_hybrid.measuring.sampling import sample

pytest.importorskip("llvmlite")

#: Torques are about 10 N m and the replay's local tolerance is 1e-5 of them.
TORQUE = 1e-3
#: The two servos start their integrals a sample apart; that has died out by then [s].
SETTLED = 0.2


@pytest.fixture(scope="module")
def declared():
    return load(
        find_model("testbed"), ["run.t_end=0.7 s", 'controller.stages.1.points=[["0 s", "4 V"]]']
    )


def test_a_recorded_rotor_is_replayed_by_the_projects_engine(declared):
    time = np.arange(1, 300) * 2e-3
    found = sample(run(declared), time, side="left")
    torque = -found.tau.sum(axis=1)
    inputs = {
        "command": np.full(time.size, 4.0),
        "reference_speed": np.ones(time.size),
        "neighbour_command": np.zeros(time.size),
    }
    observed = {"clutch_torque": Observation(torque, 0.2, np.ones(time.size, bool))}
    replay = Replay("run 1", "run 1", time, inputs, observed)
    predictor = ScenarioPredictor(declared, RotorRig())
    values = {p.name: p.value for p in predictor.parameters}
    predicted = predictor.predict(values, [replay])
    late = time > SETTLED
    assert torque[late].max() > 5.0
    assert np.abs(predicted["clutch_torque"][0] - torque)[late].max() < TORQUE
    assert np.abs(predicted["speed"][0] - found.qd[:, 0])[late].max() < TORQUE


def test_the_corrected_model_is_a_scenario_file_with_the_fitted_numbers(declared):
    values = {p.name: p.value for p in ScenarioPredictor(declared, RotorRig()).parameters}
    values["slip torque scale"] = 1.02
    made = corrected_scenario(declared, (), values)
    again = parse(resolve(made).text)
    a, b = declared.clutches[0].torque.a, again.clutches[0].torque.a
    assert b == pytest.approx(1.02 * a, rel=1e-12)
    assert again.notes["tolerances"] == declared.notes["tolerances"]
