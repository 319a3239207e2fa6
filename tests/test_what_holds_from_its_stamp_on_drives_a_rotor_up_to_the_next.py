"""What holds from its stamp on drives a rotor up to the next, from the first stamp on."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.identification.rotor.rows import as_rotor

STAMPS = 2e-3 * np.arange(1, 5)


# Of what held up to the first stamp a map with "after" tells nothing: that row is left out.
@pytest.mark.parametrize(
    ("held", "first", "values"),
    [("after", 1, [0.0, 1.0, 2.0]), ("before", 0, [0.0, 1.0, 2.0, 3.0])],
)
def test_a_row_has_what_held_up_to_it(held, first, values):
    run = RecordedRun("run", "run", "", (0, 4), STAMPS, {"command": np.arange(4.0)})
    channel = ChannelMap("command", "V", "V", "input", held=held)
    described = RecordingMap("map", channel, {"command": channel})
    found = as_rotor(Recording("file", described, (run,)))
    assert found.runs[0].channels["command"].tolist() == values
    assert found.runs[0].time.tolist() == STAMPS[first:].tolist()
    assert found.channels["command"].held == "before"
