"""Two declared parameters that differ from run to run, at once."""

import numpy as np
import pytest
from axis_recordings import MODEL, recorded_axis

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.reporting.sentences import verdict_sentence

FRICTION, INERTIA = (1.1, 0.9, 1.0), (0.97, 1.03, 1.0)
TOLERANCE = """
[[tolerances]]
name = "inertia"
parameters = ["device.inertia"]
relative = 0.05
"""


@pytest.mark.slow
def test_both_are_told(tmp_path):
    recording = recorded_axis(tmp_path, [], drive="told", friction=FRICTION, inertia=INERTIA)
    found = diagnose(recording, parse(MODEL + TOLERANCE), candidates=())
    assert found.search.verdict.kind == "unknown"
    levels = {r.parameter: np.array([times for _, times in r.levels]) for r in found.levels}
    assert set(levels) == {"Coulomb friction", "inertia"}
    # Half a run with noise of 2e-4 rad tells them to a thousandth; the two are fitted in turn.
    assert levels["Coulomb friction"] == pytest.approx(np.array(FRICTION[:2]), abs=0.005)
    assert levels["inertia"] == pytest.approx(np.array(INERTIA[:2]), abs=0.005)
    said = verdict_sentence(found)
    assert said.startswith("Coulomb friction (")
    assert " and inertia (" in said
    assert "differ from run to run" in said
