import numpy as np
import pytest
from axis_logged_beside import DECLARED, logged_beside

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.reporting.held_out_sentences import held_out
from simpter_hybrid.identification.result import with_curve


@pytest.mark.slow
def test_with_which_nothing_is_missing(tmp_path):
    def of_the_day(run, time):
        return 0.3 + 0.04 * ((run * 5) % 12) + 0.0 * time

    def worse(humidity):
        return 0.4 * np.tanh(4.0 * (humidity - 0.45))

    recording = logged_beside(tmp_path, "humidity", "1", of_the_day, worse)
    found = diagnose(recording, parse(DECLARED))
    assert found.search.verdict.kind == "unknown"
    assert found.empirical.coordinate == "force:humidity"
    assert held_out(found, "empirical") < 1.2 < 3.0 < held_out(found, "refitted")
    again = diagnose(recording, with_curve(found, "curved"))
    assert again.search.verdict.kind == "nothing missing"
