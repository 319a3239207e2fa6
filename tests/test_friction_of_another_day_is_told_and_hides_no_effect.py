import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.viscous_drag import ViscousDrag
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.reporting.sentences import verdict_sentence

FRICTION = (1.0, 1.1, 1.05)


@pytest.mark.slow
@pytest.mark.parametrize("drag", [0.0, 0.05])
def test_found_in_two_takes(tmp_path, drag):
    hidden = [ViscousDrag(coordinate=0, coefficient=drag)] if drag else []
    found = diagnose(recorded_axis(tmp_path, hidden, friction=FRICTION), declared_axis())
    done = found.search
    levels = np.array([times for _, times in found.levels[0].levels])
    # Noise of 0.2 mrad knows the friction of 4 s to 0.1 %; what a wrong start adds is allowed for.
    assert levels == pytest.approx(np.array(FRICTION[:2]) / 1.05, abs=0.005)
    assert "differs from run to run" in verdict_sentence(found)
    if drag:
        assert [e.name for e in done.corrected.effects] == ["viscous-drag"]
    else:
        assert (done.verdict.kind, done.verdict.coordinates) == ("unknown", ("force:run",))
    assert done.corrected.select_error < 1.2 * done.floor
