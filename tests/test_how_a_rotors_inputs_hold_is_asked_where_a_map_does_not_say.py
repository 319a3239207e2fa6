"""A rotor's inputs hold up to their stamps; a map that does not say so is asked."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.identification.rotor.rows import as_rotor, untold_holds

STEPS = np.repeat([0.0, 1.0], 50)


# How a command that never changes holds between its rows is all the same.
@pytest.mark.parametrize(
    ("held", "values", "asked"),
    [
        ("sampled", STEPS, 1),
        ("before", STEPS, 0),
        ("after", STEPS, 0),
        ("sampled", np.ones(100), 0),
    ],
    ids=["not told", "before", "after", "constant"],
)
def test_an_input_that_changes_is_asked_about(held, values, asked):
    run = RecordedRun("run", "run", "", (0, 100), 2e-3 * np.arange(1, 101), {"command": values})
    channel = ChannelMap("command", "V", "V", "input", held=held)
    described = RecordingMap("map", channel, {"command": channel})
    found = untold_holds(as_rotor(Recording("file", described, (run,))))
    assert len(found) == asked
    assert all("command" in f.what and "held" in f.right for f in found)
