"""The studies' standard runs and the files a user runs are the same scenarios."""

import numpy as np
import pytest

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.rigs.line import line

RUNS = {
    "line-y24": line(),
    "line-y24-p016": line(gain=0.16),
    "line-y24-velocity": line("velocity", 0.16),
    "line-y24-velocity-gradual": line("velocity", 0.16, fade=0.02),
}


@pytest.mark.parametrize("name", RUNS)
def test_same_parameters(name):
    mine, shipped = RUNS[name], load(name)
    assert mine.parameter_names() == shipped.parameter_names()
    # Degrees and pi agree to rounding; all else is the same float.
    np.testing.assert_allclose(mine.parameter_values(), shipped.parameter_values(), rtol=1e-12)
    assert mine.q == pytest.approx(shipped.q, rel=1e-12)
    assert mine.period == shipped.period


def test_same_run():
    mine, shipped = (simulate(s) for s in (RUNS["line-y24-p016"], load("line-y24-p016")))
    assert [e.after for e in mine.events] == [e.after for e in shipped.events]
    # A start that differs by rounding moves the end by that, times at most a thousand.
    assert mine.t_end == pytest.approx(shipped.t_end, abs=1e-11)
