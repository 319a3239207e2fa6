"""Only the set point and the motion were logged: the model's own servo follows the record."""

from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.compiled import simulate
from simpter_hybrid.identification.axis_replays import AxisSignals, axis_replays
from simpter_hybrid.identification.axis_rig import AxisRig
from simpter_hybrid.identification.recording import RecordedRun, Recording
from simpter_hybrid.identification.recording_map import ChannelMap, RecordingMap
from simpter_hybrid.identification.scenario_predictor import ScenarioPredictor
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.sampling import sample
from simpter_hybrid.scenario_file import parse

MODEL = """
[run]
t_end = "3 s"
[device]
kind = "one-axis"
inertia = "0.02 kg*m^2"
[start]
coordinates = ["0 rad"]
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "0.1 N*m", viscous = "0.02 N*m*s/rad" }
[[loads]]
kind = "force-drive"
constant = "1 N*m/V"
[controller]
rate = "1 kHz"
[[controller.stages]]
kind = "position-servo"
points = [["0 s", "0 rad"], ["1 s", "1 rad"], ["3 s", "-0.5 rad"]]
proportional = "3 V/rad"
derivative = "0.05 V*s/rad"
limit = "2 V"
[[tolerances]]
name = "Coulomb friction"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.2
"""


def recorded():
    """The servo's run without noise, every 2 ms."""
    time = np.arange(0.0, 3.0, 0.002)
    angle = sample(simulate(parse(MODEL)), time).q[:, 0]
    wanted = np.interp(time, [0.0, 1.0, 3.0], [0.0, 1.0, -0.5])
    roles = {"position": "measured", "reference": "input"}
    channels = {n: ChannelMap(n, n, "rad", role) for n, role in roles.items()}
    run = RecordedRun("run", "run", "run", (0, time.size), time,
                      {"position": angle, "reference": wanted})  # fmt: skip
    return Recording("file", RecordingMap("map", channels["position"], channels), (run,))


def test_the_loop_gives_the_motion_back():
    replay = axis_replays(recorded(), AxisSignals())[0]
    told = ScenarioPredictor(parse(MODEL), AxisRig(servo=True)).predict(
        {"Coulomb friction": 1.0}, [replay]
    )
    # The set point is played half a millisecond late, at 1 rad/s; windows start on cubics.
    assert told["position"][0] == pytest.approx(replay.notes["position"], abs=2e-3)


def test_a_model_without_a_servo_is_told_what_it_needs():
    with pytest.raises(InvalidInput, match="position-servo"):
        AxisRig(servo=True).template(replace(parse(MODEL), controllers=()))
