"""Commands of clutches that were recorded beside two driven joints drive the model's clutches."""

from dataclasses import replace

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.identification.axis.joints_rig import JointsRig, joint_replays, refuse_others
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.problems import InvalidInput

#: Rest of a clutch whose command was not recorded [V].
REST = 1.5


def steps(folder, channel="command_2"):
    """A run whose command steps from 0 to 4 V at its hundredth row."""
    return recorded_joints(folder, declared_joints(), commands={channel: 100 * [0.0] + 300 * [4.0]})


def test_each_at_its_own_rows_and_the_others_stay_as_declared(tmp_path):
    (replay,) = joint_replays(steps(tmp_path))
    held = replace(replay, notes=replay.notes | {"holds": np.ones(3)})  # from its stamp on
    count, every, rows, *told = JointsRig(held=(REST, 0.0)).pack(held, 0.005)
    assert (count, every) == (2, 1)
    table = np.reshape(told, (int(rows), 5))
    assert set(table[:, 3]) == {REST}
    assert table[:100, 4] == pytest.approx(0.0)
    assert table[100:, 4] == pytest.approx(4.0)


@pytest.mark.parametrize("lag", [0.0, 0.3])
def test_a_constant_one_presses_from_the_first_row_on(tmp_path, lag):
    declared = declared_joints(pressed=0.05, lag=lag)
    (replay,) = joint_replays(recorded_joints(tmp_path, declared, command=4.0))
    predictor = ScenarioPredictor(declared, JointsRig(held=(0.0, 0.0)))
    values = {p.name: p.value for p in predictor.parameters}
    silent = replace(replay, inputs=replay.inputs | {"command_1": 0.0 * replay.time})
    measured = replay.observed["speed_1"].values
    played, unplayed = (
        float(np.nanstd((predictor.predict(values, [run])["speed_1"][0] - measured)[:100]))
        for run in (replay, silent)
    )
    assert played < 0.05 * unplayed


def test_one_of_no_clutch_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match=r"no clutch of the model.*command_3"):
        refuse_others(steps(tmp_path, "command_3"), 2)
