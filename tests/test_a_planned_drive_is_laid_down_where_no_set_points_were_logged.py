"""Beside a motion that is planned its drive is told, unless a servo's set points were logged."""

import pytest
from axis_recordings import MAP, declared_axis, recorded_axis

from simpter_hybrid.identification.axis.motor import motor_of
from simpter_hybrid.identification.axis.plan import axis_reach, planned_axis
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.recording import load_recording

SET_POINTS = '[channels.reference]\ncolumn = "angle"\nunit = "deg"\nsign = -1\nrole = "input"\n'


@pytest.mark.parametrize(
    ("more", "laid"), [("", ["position", "torque"]), (SET_POINTS, ["position"])]
)
def test_what_is_laid_down(more, laid, tmp_path):
    recorded_axis(tmp_path, [])
    (tmp_path / "map.toml").write_text(MAP + more, encoding="utf-8")
    recording = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    declared, signals = declared_axis(), AxisSignals()
    reach = axis_reach(axis_replays(recording, signals), 0.02, motor_of(declared)[1])
    _, laid_down = planned_axis(recording, declared, reach, signals)
    assert {tuple(x) for x in laid_down.values()} == {tuple(laid)}
