"""An inertia fitted at ten times the declared one, which is as far as is tried, is no estimate."""

import numpy as np
import pytest
from toy_rig import ALONG_X

from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.reporting import round_data as rounds
from simpter_hybrid.identification.reporting.tables import AT_BOUND, candidate_table
from simpter_hybrid.identification.tracing.round import Round
from simpter_hybrid.identification.tracing.verdict import Verdict


@pytest.mark.parametrize(("gain", "marked"), [(5.0, True), (-5.0, True), (4.9, False)])
def test_only_there(monkeypatch, gain, marked):
    monkeypatch.setattr(rounds, "by_chance", lambda *_: False)
    fit = Fit({"gain": gain}, 1.0, np.zeros((1, 1)), np.zeros(1))
    trial = Trial(ALONG_X, fit, 0.9, 0.1, 0.5)
    data = rounds.round_data(Round({}, {}, (trial,), Verdict("unknown")), None)
    assert (f"gain {gain:g}{AT_BOUND}" in candidate_table(0, data)) is marked
