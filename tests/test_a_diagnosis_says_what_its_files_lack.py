"""A map without a channel, a tolerance of no parameter: said before anything is computed."""

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.fits import check_signals, check_tolerances
from simpter_hybrid.identification.maps import find_map, find_model
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.problems import InvalidInput


def test_every_channel_that_is_missing_is_named():
    recording = Recording("runs.csv", read_map(find_map("emps", "", find_model("emps"))), ())
    with pytest.raises(InvalidInput) as caught:
        check_signals(recording, ("position", "speed", "command"))
    assert [p.path for p in caught.value.problems] == ["channels.speed", "channels.command"]


def test_a_tolerance_of_no_parameter_is_refused():
    wrong = [{"name": "mass", "parameters": ["device.weigth"], "relative": 0.1}]
    declared = load(find_model("emps"))
    with pytest.raises(InvalidInput, match=r"device\.weigth"):
        check_tolerances(declared.replace(notes={"tolerances": wrong}))
    with pytest.raises(InvalidInput, match="tolerances"):
        check_tolerances(declared.replace(notes={}))


def test_an_unknown_model_lists_those_that_come_with_the_program():
    with pytest.raises(InvalidInput, match="testbed"):
        find_model("no such model")
