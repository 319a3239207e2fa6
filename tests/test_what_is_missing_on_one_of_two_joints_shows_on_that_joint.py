"""A torque on one joint accelerates both: by the mass matrix its balance is its own joint's."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.identification.axis.drive_force import motors_of
from simpter_hybrid.identification.axis.joints_rig import JointsRig, JointsTracer, joint_replays
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor

#: A torque that the model lacks [N m], and how fast it changes [rad/s].
MISSING, RATE = 0.1, 5.0


@pytest.mark.parametrize("joint", [0, 1])
def test_a_torque_is_missing_on_its_own_joint_alone(tmp_path, joint):
    declared = declared_joints()
    (replay,) = joint_replays(recorded_joints(tmp_path, declared))
    replay = replace(replay, notes=replay.notes | {"start_at": np.array([0])})
    motors = tuple(motors_of(declared, j) for j in range(2))
    tracer = JointsTracer(declared, (2 * np.pi,) * 2, motors)
    lacks = np.outer(MISSING * np.cos(RATE * replay.time), np.eye(2)[joint])
    gained = np.linalg.solve(tracer.masses(replay), lacks[..., None])[..., 0]
    step = float(np.median(np.diff(replay.time)))

    def predict(values, replays):
        told = {"friction_1": [0.0 * replay.time], "friction_2": [0.0 * replay.time]}
        for k in range(2):
            speed = replay.notes[f"speed_{k + 1}"] - np.cumsum(gained[:, k]) * step
            told |= {f"speed_{k + 1}": [speed], f"acceleration_{k + 1}": [np.gradient(speed, step)]}
        return told

    traces = tracer(SimpleNamespace(predict=predict), {}, [replay])
    sizes = [float(np.std(traces[f"joint_{k + 1}"][0].residual)) / MISSING for k in range(2)]
    # Slopes over 0.06 s, one-sided at the ends, and means over blocks: within a twentieth.
    expected = np.std(np.cos(RATE * replay.time)) * np.eye(2)[joint]
    assert sizes == pytest.approx(expected.tolist(), abs=0.05)


def test_commands_of_its_clutches_are_played(tmp_path):
    declared = declared_joints(pressed=0.05)
    (replay,) = joint_replays(recorded_joints(tmp_path, declared, command=4.0))
    predictor = ScenarioPredictor(declared, JointsRig(held=(0.0, 0.0)))
    values = {p.name: p.value for p in predictor.parameters}
    silent = replace(replay, inputs=replay.inputs | {"command_1": 0.0 * replay.time})
    measured = replay.observed["speed_1"].values
    played, unplayed = (
        float(np.nanstd(predictor.predict(values, [run])["speed_1"][0] - measured))
        for run in (replay, silent)
    )
    assert played < 0.05 * unplayed
