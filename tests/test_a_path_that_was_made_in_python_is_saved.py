"""A note `path` may be a line or a circle; the file of the run has its numbers."""

import pytest

import simpter_hybrid as simpter
from simpter_hybrid.measuring.desired_path import Circle, Line, desired_path

SHORT = ["run.t_end=20 ms"]


@pytest.mark.parametrize("path", [Line(0.0, 0.6, 0.25), Circle(0.1, 0.6, 0.2)])
def test_it_is_read_back(tmp_path, path):
    scenario = simpter.load("line-y24", SHORT)
    run = simpter.run(scenario.replace(notes={**scenario.notes, "path": path}))
    simpter.save(run, tmp_path / "out")
    assert desired_path(simpter.load_run(tmp_path / "out").scenario) == path
