"""Measures take their samples from those at hand, or anew where an instant is not among them."""

from dataclasses import fields

import numpy as np
import pytest

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.measuring.metrics import _among
from simpter_hybrid.measuring.sampling import output_grid, sample


@pytest.fixture(scope="module")
def run():
    return simulate(load("testbed-breakaway-7v", ["run.t_end=1 s"]))


@pytest.mark.parametrize("beyond", [0.0, 1e-9, 1e9])
def test_they_are_the_same_either_way(run, beyond):
    there = sample(run, *output_grid(run, 0.01))
    times = np.array([0.0, 0.3 + min(beyond, 1e-9), run.t_end])
    if beyond > 1.0:  # none of the grid is as late
        there = there.rows(np.arange(5))
    found, right = _among(there, run, times), sample(run, times)
    for one in fields(right):
        np.testing.assert_equal(getattr(found, one.name), getattr(right, one.name))
