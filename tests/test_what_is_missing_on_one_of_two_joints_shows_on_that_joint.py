"""A torque on one joint accelerates both: by the mass matrix its balance is its own joint's."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.identification.axis.drive_force import motors_of
from simpter_hybrid.identification.axis.joints_rig import JointsTracer, joint_replays

#: A torque that the model lacks [N m], and how fast it changes [rad/s].
MISSING, RATE = 0.1, 5.0


def textbook(arm, replay):
    """Mass matrix of two links in every row: M. Spong et al. (2006), section 7.3."""
    bent = np.cos(replay.notes["position_2"])
    far = arm.inertia_2 + arm.mass_2 * arm.length_1 * arm.centre_2 * bent
    near = arm.inertia_1 + arm.mass_2 * arm.length_1**2 + 2.0 * far - arm.inertia_2 + arm.rotor_1
    last = np.full(bent.size, arm.inertia_2 + arm.rotor_2)
    return np.array([[near, far], [far, last]]).transpose(2, 0, 1)


@pytest.mark.parametrize("joint", [0, 1])
def test_a_torque_is_missing_on_its_own_joint_alone(tmp_path, joint):
    declared = declared_joints()
    (replay,) = joint_replays(recorded_joints(tmp_path, declared))
    replay = replace(replay, notes=replay.notes | {"start_at": np.array([0])})
    motors = tuple(motors_of(declared, j) for j in range(2))
    tracer = JointsTracer(declared, (2 * np.pi,) * 2, motors)
    lacks = np.outer(MISSING * np.cos(RATE * replay.time), np.eye(2)[joint])
    gained = np.linalg.solve(textbook(declared.device, replay), lacks[..., None])[..., 0]
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
