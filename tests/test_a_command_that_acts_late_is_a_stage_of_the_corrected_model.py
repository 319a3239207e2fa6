"""CommandDelay against closed forms of a lag, and as what a rotor's recording may lack."""

from math import exp

import numpy as np
import pytest
from devices_for_tests import Coulomb, RecordedCommands

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.command_delay import CommandDelay
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load, parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rotor.library import rotor_library
from simpter_hybrid.identification.rotor.rig import RotorRig
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario

#: Lag of the clutch, sample, and duration [s]; a step from 1 to 5 V at the tenth sample.
LAG, SAMPLE, T = 0.1, 0.01, 0.4
COMMANDS = (*10 * (1.0,), *31 * (5.0,))


def late(delay):
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=LAG)
    return Scenario(
        "late", Testbed(1e6), (clutch,), (0.0,), (5.0,), T, period=SAMPLE, rec=COMMANDS,
        controllers=((RecordedCommands(1.0), 1), (CommandDelay(delay), 1)),
        command=(1.0,), excitation=(1.0,),
    )  # fmt: skip


@pytest.mark.parametrize("delay", [0.0, 0.01, 0.1])
def test_whole_samples_late_the_excitation_rises_so_much_later(delay):
    end = simulate(late(delay)).end[2]
    assert end == pytest.approx(5.0 - 4.0 * exp(-(T - 0.1 - delay) / LAG), abs=1e-8)


def test_between_two_samples_the_mean_of_both_is_told():
    # 1 V to 0.13 s, then 2.2 V (0.7 of the sample is still 1 V), then 5 V.
    at = 2.2 - 1.2 * exp(-SAMPLE / LAG)
    expected = 5.0 - (5.0 - at) * exp(-(T - 0.14) / LAG)
    assert simulate(late(0.037)).end[2] == pytest.approx(expected, abs=1e-8)


def test_more_than_is_kept_is_refused():
    with pytest.raises(InvalidInput, match=r"beyond the past that is kept.*at most 0\.63 s"):
        validate(late(0.7))


@pytest.mark.parametrize("seen", [("clutch_torque",), ("clutch_torque", "speed")])
def test_the_corrected_model_predicts_what_the_fit_did(seen):
    declared = load(find_model("testbed"))
    (found,) = (c for c in rotor_library(declared) if c.name == "command-delay")
    time = 2e-3 * np.arange(1, 300)
    inputs = {
        "command": np.where(time < 0.3, 4.0, 8.0), "reference_speed": np.ones(time.size),
        "neighbour_command": np.zeros(time.size), "reference_torque": np.full(time.size, 30.0),
    }  # fmt: skip
    # A run whose speed is seen is driven by its torque.
    observed = dict.fromkeys(seen, Observation(np.zeros(time.size), 0.2, np.ones(time.size, bool)))
    replay = Replay("run", "run", time, inputs, observed)
    bare = ScenarioPredictor(declared, RotorRig())
    fitted = bare.extended(found)
    values = {p.name: p.value for p in fitted.parameters} | {"command-delay.delay": 0.0085}
    text = resolve(fitted.scenario(values)).text
    assert 'kind = "command-delay"' in text
    written = ScenarioPredictor(parse(text), RotorRig())
    nominal = {p.name: p.value for p in written.parameters}
    by_fit, by_file, without = (
        model.predict(of, [replay])["clutch_torque"][0]
        for model, of in ((fitted, values), (written, nominal), (bare, nominal))
    )
    assert by_file == pytest.approx(by_fit, abs=1e-9)  # the same program
    assert np.abs(by_fit - without).max() > 1.0  # [N m]: 8.5 ms at a rate of over 200 N m/s
