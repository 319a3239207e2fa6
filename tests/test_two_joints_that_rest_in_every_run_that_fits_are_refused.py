import numpy as np
import pytest
from two_joints import declared_joints, written

from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.problems import InvalidInput


def test_no_run_moves(tmp_path):
    time = 0.005 * np.arange(2000)
    noise = np.random.default_rng(1)
    angle = np.where(time < 5.0, 0.0, 1.0 - np.cos(time - 5.0))  # the last two of four runs move
    columns = {}
    for j in (1, 2):
        columns |= {f"position_{j}": angle, f"speed_{j}": np.gradient(angle, time)}
        columns[f"torque_{j}"] = noise.normal(0.0, 0.01, time.size)
    recording = written(tmp_path, time, columns, pieces=4)
    with pytest.raises(InvalidInput, match=r"split\.fit: no run of it moves"):
        bench_of(recording, declared_joints(), groups_of(recording))
