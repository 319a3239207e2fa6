"""A logged temperature gives an effect by its name."""

import numpy as np
import pytest
from axis_logged_beside import DECLARED, logged_beside

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.reporting.held_out_sentences import held_out
from simpter_hybrid.identification.result import corrected
from simpter_hybrid.plots.added import added_terms
from simpter_hybrid.plots.diagnosis import strongest


@pytest.mark.slow
def test_friction_by_a_logged_temperature_is_named_and_its_model_lacks_nothing(tmp_path):
    recording = logged_beside(
        tmp_path, "temperature", "degC", warming, lambda t: -0.02 * (t - 30.0)
    )
    found = diagnose(recording, parse(DECLARED))
    done = found.search
    assert [e.name for e in done.corrected.effects] == ["friction-by-temperature"]
    (effect,) = corrected(found, "warm").effects
    # At the reference friction is what was refitted: -0.02 of that at 30 degrees.
    there = 1.0 - 0.02 * (effect.reference - 303.15)
    assert effect.change == pytest.approx(-0.02 / there, rel=0.03)
    assert held_out(found) == pytest.approx(1.0, abs=0.05)
    (term,) = added_terms(found)
    assert term.coordinate == "temperature"
    assert strongest(done.rounds[0])[1].coordinate == "temperature"
    assert diagnose(recording, corrected(found, "warm")).search.verdict.kind == "nothing missing"


def warming(run, time):
    """In celsius; every other run cools."""
    return 25.0 + (run * 5) % 12 + (1 - 2 * (run % 2)) * 4.0 * np.sin(0.3 * time)


@pytest.mark.slow
def test_dry_friction_that_changes_alone_is_told_from_what_is_viscous(tmp_path):
    dry = lambda t: -0.02 * (t - 30.0)  # noqa: E731
    recording = logged_beside(tmp_path, "temperature", "degC", warming, dry, viscous=0.0)
    found = diagnose(recording, parse(DECLARED))
    assert [e.name for e in found.search.corrected.effects] == ["friction-by-temperature-2"]
    dries, thins = corrected(found, "warm").effects
    there = 1.0 - 0.02 * (dries.reference - 303.15)
    assert dries.change == pytest.approx(-0.02 / there, rel=0.03)
    # All friction is drier by the factor: the drag makes up for it.
    assert thins.change == pytest.approx(0.02 / there * 4.0, rel=0.1)
    assert held_out(found) == pytest.approx(1.0, abs=0.05)
