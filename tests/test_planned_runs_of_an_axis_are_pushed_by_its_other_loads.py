"""A planned run is one of the whole model: what pushes beside its motor pushes there too."""

from dataclasses import replace

import numpy as np
from axis_recordings import MAP, declared_axis, recorded_axis

from simpter_hybrid.identification.axis.motor import motor_of
from simpter_hybrid.identification.axis.plan import axis_reach, planned_axis
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.loads.ramp import RampOnCoordinate

PUSH = 0.1


def test_the_drive_that_is_laid_down_bears_against_a_constant_push(tmp_path):
    recorded_axis(tmp_path, [])
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    declared, signals = declared_axis(), AxisSignals()
    reach = axis_reach(axis_replays(recording, signals), 0.02, motor_of(declared)[1])
    pushed = replace(declared, loads=(RampOnCoordinate(base=PUSH), *declared.loads))
    asked = [planned_axis(recording, model, reach, signals)[1] for model in (declared, pushed)]
    # Of all plans this one leaves the drive farthest from its limit.
    without, beside = (plan["slow strokes both ways"]["torque"] for plan in asked)
    # The servo gives way by 0.015 rad: in the mean the weight there differs by 0.5 % of the push.
    np.testing.assert_allclose(np.mean(without - beside), PUSH, rtol=0.02)
