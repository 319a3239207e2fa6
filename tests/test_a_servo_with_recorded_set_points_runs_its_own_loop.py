"""Only the set point and the motion were logged: the model's own servo follows the record."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis

from simpter_hybrid.compiled import simulate
from simpter_hybrid.identification.axis_replays import AxisSignals, axis_replays
from simpter_hybrid.identification.axis_rig import AxisRig
from simpter_hybrid.identification.recording import RecordedRun, Recording
from simpter_hybrid.identification.recording_map import ChannelMap, RecordingMap
from simpter_hybrid.identification.scenario_predictor import ScenarioPredictor
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.sampling import sample


def recorded():
    """The servo's run without noise, every 2 ms."""
    time = np.arange(0.0, 4.0, 0.002)
    angle = sample(simulate(declared_axis()), time).q[:, 0]
    wanted = np.interp(time, [0.0, 1.0], [0.0, 1.0])
    roles = {"position": "measured", "reference": "input"}
    channels = {n: ChannelMap(n, n, "rad", role) for n, role in roles.items()}
    run = RecordedRun("run", "run", "run", (0, time.size), time,
                      {"position": angle, "reference": wanted})  # fmt: skip
    return Recording("file", RecordingMap("map", channels["position"], channels), (run,))


def test_the_loop_gives_the_motion_back():
    replay = axis_replays(recorded(), AxisSignals())[0]
    told = ScenarioPredictor(declared_axis(), AxisRig(servo=True)).predict(
        {"Coulomb friction": 1.0}, [replay]
    )
    # The set point is played a millisecond early, at 1 rad/s; windows start on cubics.
    assert told["position"][0] == pytest.approx(replay.notes["position"], abs=2e-3)


def test_a_model_without_a_servo_is_told_what_it_needs():
    with pytest.raises(InvalidInput, match="position-servo"):
        AxisRig(servo=True).template(replace(declared_axis(), controllers=()))
