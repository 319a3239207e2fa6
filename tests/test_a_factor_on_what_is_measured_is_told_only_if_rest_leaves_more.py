"""A position times a thousand is so large that any model rests beside it, and errs far less."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification import hopeless
from simpter_hybrid.identification.doubted_channels import Doubt
from simpter_hybrid.identification.map_changes import Times


@pytest.mark.parametrize(("left", "told"), [(0.04, True), (0.06, False)])
def test_by_half_of_what_that_leaves(monkeypatch, left, told):
    found = {"input": None, "measured": Doubt(Times(("position",), 1000.0), left)}
    monkeypatch.setattr(hopeless, "least_wrong", lambda *given: found[given[-1]])
    monkeypatch.setattr(hopeless, "weighted_residuals", lambda *given: np.ones(3))
    said = "".join(hopeless._nearest(Some(predictor=None), None, {}, {}, (), most=0.05))
    assert ("position times 1000 leaves 4 % of the error" in said) is told
    assert bool(said) is told
