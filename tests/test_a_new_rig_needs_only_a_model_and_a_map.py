"""An axis that nobody has written code for, in its own units, is diagnosed by two TOML files."""

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.asymmetry import Asymmetry
from simpter_hybrid.identification.diagnosis import diagnose


@pytest.mark.slow
def test_friction_that_differs_with_direction_is_named(tmp_path):
    recording = recorded_axis(tmp_path, [Asymmetry(clutch=0, share=0.25)])
    found = diagnose(recording, declared_axis())
    assert found.diagnosis.verdict.accepted.candidate.name == "asymmetry"
    share = found.diagnosis.corrected.values["asymmetry.share"]
    # Speeds come from noisy positions by parabolas over 30 ms: some per cent of friction.
    assert share == pytest.approx(0.25, abs=0.05)
    assert found.errors["after"]["speed"] < 0.5 * found.errors["refitted"]["speed"]
