"""``[path]`` is said once: controllers take x, y, angle or radius from it, and may differ."""

import pytest

from simpter_hybrid.files.scenario_file import parse

HEAD = """
[run]
t_end = "1 s"
[device]
kind = "pter"
[start]
tip = ["3 in", "24 in"]
[clutch.torque]
kind = "testbed"
[path]
{path}
[controller]
rate = "150 Hz"
[[controller.stages]]
kind = "{kind}"
stiffness = "32 lbf/in"
damping = "0.7 lbf*s/in"
{more}
"""
LINE = 'kind = "line"\npoint = ["1 m", "2 m"]\nangle = "90 deg"'
CIRCLE = 'kind = "circle"\ncentre = ["1 m", "2 m"]\nradius = "3 m"'


def stage(path, kind, more=""):
    scenario = parse(HEAD.format(path=path, kind=kind, more=more))
    return scenario.controllers[0][0], scenario.notes["path"]


def test_a_line():
    found, noted = stage(LINE, "impedance-to-line")
    assert (found.x, found.y) == (1.0, 2.0)
    assert found.angle == pytest.approx(1.5707963267948966, rel=1e-15)
    assert noted == {"x": found.x, "y": found.y, "angle": found.angle}


def test_a_circle():
    found, noted = stage(CIRCLE, "impedance-to-circle")
    assert (found.x, found.y, found.radius) == (1.0, 2.0, 3.0)
    assert noted == {"x": 1.0, "y": 2.0, "radius": 3.0}


def test_what_the_stage_says_itself_counts():
    found, noted = stage(LINE, "impedance-to-line", 'y = "5 m"')
    assert (found.x, found.y, noted["y"]) == (1.0, 5.0, 2.0)
