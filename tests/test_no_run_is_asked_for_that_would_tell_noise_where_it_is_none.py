"""Driven once more a run tells noise, but not of what is too far above it on any runs."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.lack_sentences import lack_sentence
from simpter_hybrid.identification.tracing.limits import SIMULATED_AXIS
from simpter_hybrid.identification.tracing.verdict import Verdict


@pytest.mark.parametrize(
    ("selecting", "fitted", "told", "advised"),
    [
        (6.0, 6.0, False, ": noise does not come again"),
        (6.0, 11.0, False, ""),
        (28.0, 20.0, True, ": what a driver gives by itself does not come again"),
        (28.0, 120.0, True, ""),
    ],
)
def test_the_runs_that_are_farthest_off_decide(selecting, fitted, told, advised):
    model = SimpleNamespace(select_error=selecting, residuals=np.full(9, fitted))
    search = SimpleNamespace(
        verdict=Verdict("unknown"), refitted=model, corrected=model, floor=1.0, rounds=()
    )
    found = SimpleNamespace(
        search=search, limits=SIMULATED_AXIS._replace(told=told), floors=Floors(1.0, 1.0, 1.0),
        taken_back=None, recording=None, remarks=(),
    )  # fmt: skip
    said = lack_sentence(found)
    assert advised in said
    assert ("does not come again" in said) is bool(advised)
