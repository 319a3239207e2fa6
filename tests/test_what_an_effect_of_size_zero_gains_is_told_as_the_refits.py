"""A candidate that ends with nothing of itself has gained by the refit beside it."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import ALONG_X

from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.reporting.tables import IDLE, candidate_table

SIZED = replace(ALONG_X, sizes=("gain",))


def trial(candidate, gain):
    fit = Fit({"gain": gain}, 1.0, np.zeros((1, 1)), np.zeros(1))
    return Trial(candidate, fit, 0.9, 0.1, 0.5)


@pytest.mark.parametrize(
    ("candidate", "gain", "idle"),
    [(SIZED, 0.0, True), (SIZED, 0.01, False), (ALONG_X, 0.0, False)],
)
def test_only_an_effect_with_sizes_that_are_zero_is_idle(candidate, gain, idle):
    assert trial(candidate, gain).idle is idle


@pytest.mark.parametrize("idle", [True, False])
def test_its_row_says_so(idle):
    row = {
        "name": "stribeck", "port": "friction", "gain": 0.0152, "share": 0.1, "held_out": None,
        "values": {"stribeck.rise": 0.0}, "idle": idle, "by_chance": False,
    }  # fmt: skip
    page = candidate_table(0, {"verdict": "unknown", "candidates": [row]})
    assert (f"1.52 %{IDLE}" in page) is idle
