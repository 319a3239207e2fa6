"""A copied run would be a repetition without noise, or a run held out that was fitted."""

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.problems import InvalidInput

WAVE = np.sin(0.1 * np.arange(100))


def _rows(*angles):
    return ["take,ms,angle,torque"] + [
        f"{take},{4 * k},{angle:.4f},{force:.4f}"
        for take, seen in enumerate(angles)
        for k, (angle, force) in enumerate(zip(seen, WAVE, strict=True))
    ]


def test_every_copy_is_named_with_the_run_it_is_of(tmp_path):
    with pytest.raises(InvalidInput) as told:
        written(tmp_path, _rows(WAVE, WAVE, 2 * WAVE, WAVE), MAP)
    found = [str(problem) for problem in told.value.problems]
    assert ["take 1" in found[0], "take 3" in found[1], len(found)] == [True, True, 2]
    assert all("the same measurements as in take 0" in text for text in found)


def test_runs_that_rest_throughout_are_no_copies(tmp_path):
    rest = np.zeros(100)
    assert len(written(tmp_path, _rows(WAVE, rest, rest, 2 * WAVE), MAP).runs) == 4
