"""A command presses as a pressure does; a current drives; what nothing uses is said."""

from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.identification.axis.recorded import as_axis, unused
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.benches import as_recorded
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording
from simpter_hybrid.loads.drive import CurrentDrive, ForceDrive

TIME = np.arange(0.0, 2.0, 0.01)


def of(**units):
    """A recording of channels with such units, each at its number from 1 on."""
    channels = {name: ChannelMap(name, name, unit, "input") for name, unit in units.items()}
    series = {name: k + np.sin(TIME) for k, name in enumerate(units, 1)}
    run = RecordedRun("run", "run", "run", (0, TIME.size), TIME, series)
    return Recording("file", RecordingMap("map", channels["position"], channels), (run,))


def test_a_command_is_what_presses():
    made = as_axis(of(position="m", force="N", command="V"))
    assert "command" not in made.channels
    replay = axis_replays(made, AxisSignals())[0]
    assert np.array_equal(replay.inputs["press"], 3 + np.sin(TIME))


def test_a_command_beside_a_pressure_is_not_used_and_that_is_said():
    made = as_axis(of(position="m", force="N", pressure="Pa", command="V"))
    (remark,) = unused(made, AxisSignals().all)
    assert "nothing uses the channel command" in remark.what


@pytest.mark.parametrize(("role", "name"), [("input", "force"), ("measured", "torque")])
def test_a_torque_is_what_a_tester_measures_and_else_what_drives(role, name):
    known = of(position="rad", torque="N*m")
    place = replace(known.channels["position"], role=role)
    torque = replace(known.channels["torque"], role="measured")
    changed = replace(known.map, channels={"position": place, "torque": torque})
    made = as_axis(replace(known, map=changed))
    assert made.channels.keys() == {"position", name}
    assert np.array_equal(made.runs[0].channels[name], known.runs[0].channels["torque"])


def test_a_rotor_with_a_clutch_keeps_its_command():
    rotor = of(position="rad", clutch_torque="N*m", command="V")
    assert as_recorded(rotor) is rotor


def test_a_current_drives_and_a_sensor_saw_it():
    made = as_axis(of(position="m", current="A"))
    assert np.array_equal(axis_replays(made, AxisSignals())[0].inputs["drive"], 2 + np.sin(TIME))
    assert "current" in AxisSignals().sensed


def test_a_drive_of_current_is_one_of_force_with_another_unit():
    drive = CurrentDrive(constant=0.3)
    assert isinstance(drive, ForceDrive)
    assert replace(drive, constant=0.4).constant == 0.4
    assert CurrentDrive.force is ForceDrive.force
