"""Two joints: a window that starts beside a lone speed sample starts as the others do."""

from copy import deepcopy

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.identification.axis.joints_rig import joint_replays
from simpter_hybrid.identification.recordings.course import course

#: Row at which a window starts, and some of those to which its start is fitted.
START, BESIDE = 100, (97, 100, 103)
NOISE = 0.01


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    return recorded_joints(tmp_path_factory.mktemp("joints"), declared_joints())


@pytest.fixture
def runs(recorded):
    """Starts of a run with a little noise of its speeds, and of the same with a spike in a row."""
    noise = np.random.default_rng(5).normal(0.0, NOISE, (2, 400))

    def starts(spike, row):
        recording = deepcopy(recorded)
        for run in recording.runs:
            for j in range(2):
                speed = run.channels[f"speed_{j + 1}"]
                speed += noise[j, : speed.size]
            run.channels["speed_2"][row] += spike
        (replay,) = joint_replays(recording)
        assert START in replay.notes["start_at"]
        return replay.notes["states"]

    return starts


@pytest.mark.parametrize("row", BESIDE)
def test_a_lone_sample_far_off_moves_no_start(runs, row):
    moved = np.abs(runs(1.0, row) - runs(0.0, row))
    assert moved.max() < 3.0 * NOISE


@pytest.mark.parametrize(
    "motion",
    [
        lambda t: np.where(t < 0.5, 0.0, 1.0),
        lambda t: np.abs(t - 0.5),
        lambda t: np.maximum(0.0, 0.5 - t),
        lambda t: np.where(np.abs(t - 0.5) < 0.006, 1.0, 0.0),
        lambda t: np.sin(2.0 * np.pi * 60.0 * t),
    ],
    ids=["a blow", "a turn", "a stop", "a slip of three rows", "a swing of three rows a period"],
)
def test_no_motion_is_taken_for_one(motion):
    t = np.arange(0.0, 1.0, 0.005)
    values = motion(t) + np.random.default_rng(2).normal(0.0, NOISE, t.size)
    assert np.array_equal(course(t, values, NOISE), values)
