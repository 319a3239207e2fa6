"""Notes of a scenario made in Python: a path is a line, a circle, or the numbers of either."""

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.measuring.desired_path import Circle, Line, desired_path

LINE = load("line-y24")
OF_STAGE = desired_path(LINE.replace(notes={}))


@pytest.mark.parametrize("noted", ["y = 24 in", 24.0, Line])
def test_a_path_that_is_none(noted):
    with pytest.raises(TypeError, match=r"is no path; give a Line, a Circle, or numbers such as"):
        desired_path(LINE.replace(notes={"path": noted}))


@pytest.mark.parametrize(
    ("noted", "path"),
    [
        (Line(0.0, 0.6, 0.0), Line(0.0, 0.6, 0.0)),
        ({"x": 0.0, "y": 0.6, "radius": 0.1}, Circle(0.0, 0.6, 0.1)),
        (None, OF_STAGE),
    ],
)
def test_a_path_that_is_one(noted, path):
    assert desired_path(LINE.replace(notes={"path": noted})) == path
