"""One whole diagnosis of the testbed and one of the robot, of which the data say what they hide."""

import os
from pathlib import Path

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.held_out_sentences import held_out

DATA = Path(os.environ.get("SIMPTER_DATA", Path(__file__).parents[2] / "shared" / "data"))
CASES = [("testbed", "stribeck", "stribeck"), ("robot", "tilt", "tilt")]


@pytest.mark.slow
@pytest.mark.parametrize(("rig", "file", "effect"), CASES)
def test_it_is_named_first_and_leaves_the_floor(rig, file, effect):
    path = DATA / rig / "practice" / f"{file}.csv.gz"
    if not path.is_file():
        pytest.skip(f"SIMPTER_DATA has no {rig}/practice")
    found = diagnose(load_recording(path, MAPS / f"{rig}.toml"), load(find_model(rig)))
    assert [e.name for e in found.search.corrected.effects] == [effect]
    # What the method study holds a right form to.
    assert held_out(found) < 1.03
    assert found.doubts == ()
