"""Drives, or motions, of two joints that stand in one another's place are told before a search."""

from types import SimpleNamespace

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.identification.channel_factors import exchanges, with_exchanged
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.problems import InvalidInput

DRIVES = ("torque_1", "torque_2")
MOTIONS = ("position_1", "position_2", "speed_1", "speed_2")


def test_each_and_all_are_asked_and_each_pair_changes_places(tmp_path):
    recording = recorded_joints(tmp_path, declared_joints())
    assert exchanges(recording) == [DRIVES, MOTIONS, (*DRIVES, *MOTIONS)]
    (run,), (other,) = recording.runs, with_exchanged(recording, MOTIONS).runs
    for a, b in (MOTIONS[:2], MOTIONS[2:]):
        assert np.array_equal(run.channels[a], other.channels[b])
        assert np.array_equal(run.channels[b], other.channels[a])
    assert np.array_equal(run.channels["torque_1"], other.channels["torque_1"])


def test_joints_without_drives_have_none_to_exchange():
    # As a robot's are, which a hand moves.
    assert exchanges(SimpleNamespace(channels=dict.fromkeys(MOTIONS))) == []


def test_motions_are_exchanged_in_pairs():
    unit = SimpleNamespace(unit="rad")
    names = (*DRIVES, "position_1", "position_2", "speed_2")
    found = exchanges(SimpleNamespace(channels=dict.fromkeys(names, unit)))
    assert found == [DRIVES, MOTIONS[:2], (*DRIVES, *MOTIONS[:2])]


@pytest.mark.parametrize(
    "names", [DRIVES, pytest.param((*DRIVES, *MOTIONS), marks=pytest.mark.slow)]
)
def test_what_is_exchanged_is_refused_with_the_columns(tmp_path, names):
    recording = recorded_joints(tmp_path, declared_joints(), t_end=4.0, pieces=4)
    with pytest.raises(InvalidInput, match=rf"channels\.{names[0]}\.column: .* exchanged"):
        diagnose(with_exchanged(recording, names), declared_joints())
