"""Where no device says what its coordinates measure, units are judged by most of those given."""

import pytest
from axis_recordings import MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.problems import InvalidInput

SERVO = """
[[controller.stages]]
kind = "position-servo"
points = [["0 s", "0 m"], ["1 s", "0.1 m"], ["2 s", "3 s"]]
proportional = "100 V/m"
derivative = "20 V*s/m"
"""


def test_points_of_a_slide_are_lengths_although_its_mass_is_wrong():
    text = MODEL.partition("[device]")
    device = '[device]\nkind = "linear-axis"\nmass = "2 kgg"\n'
    rest = text[2][text[2].index("\n[") :]
    with pytest.raises(InvalidInput) as told:
        parse(text[0].replace("rad", "m").replace("deg", "m") + device + rest + SERVO)
    paths = [p.path for p in told.value.problems]
    assert "device.mass" in paths
    assert [p for p in paths if ".points." in p] == ["controller.stages.1.points.2.1"]
