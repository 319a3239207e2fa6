"""A brake bench on a speed servo has no torque reference, and needs no column that pretends one."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.identification.rotor.rows import as_rotor

TIME = 2e-3 * np.arange(1, 201)


@pytest.mark.parametrize(
    ("logged", "unit", "other", "dimension"),
    [("reference_speed", "rpm", "reference_torque", "N*m"),
     ("reference_torque", "lbf*in", "reference_speed", "rad/s")],
)  # fmt: skip
def test_the_other_applies_in_no_row(logged, unit, other, dimension):
    channel = ChannelMap(logged, "ref", unit, "input", scale=0.1, held="before")
    run = RecordedRun("run", "run", "", (0, TIME.size), TIME, {logged: np.sin(TIME)})
    found = as_rotor(Recording("file", RecordingMap("map", channel, {logged: channel}), (run,)))
    made, values = found.channels[other], found.runs[0].channels[other]
    assert (made.unit, made.scale, made.role) == (dimension, 1.0, "input")
    assert np.isnan(values).all()
    assert values.size == TIME.size
    assert np.array_equal(found.runs[0].channels[logged], np.sin(TIME))


def test_without_either_none_is_made_up():
    channel = ChannelMap("command", "V", "V", "input", held="before")
    run = RecordedRun("run", "run", "", (0, TIME.size), TIME, {"command": np.sin(TIME)})
    found = as_rotor(Recording("file", RecordingMap("map", channel, {"command": channel}), (run,)))
    assert list(found.channels) == ["command"]


def test_where_some_rows_are_of_no_torque_the_speed_that_was_asked_for_is_missing():
    channel = ChannelMap("reference_torque", "ref", "N*m", "input", held="before")
    runs = tuple(
        RecordedRun(name, name, "", (0, TIME.size), TIME, {"reference_torque": values})
        for name, values in (("torque", np.sin(TIME)), ("servo", np.full(TIME.size, np.nan)))
    )
    described = RecordingMap("map", channel, {"reference_torque": channel})
    assert list(as_rotor(Recording("file", described, runs)).channels) == ["reference_torque"]
