"""An axis that nobody has written code for, in its own units, is diagnosed by two TOML files."""

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.asymmetry import Asymmetry
from simpter_hybrid.effects.viscous_drag import ViscousDrag
from simpter_hybrid.identification.diagnosis import diagnose


@pytest.mark.slow
def test_nothing_is_missing_where_nothing_is(tmp_path):
    found = diagnose(recorded_axis(tmp_path, []), declared_axis())
    assert found.search.verdict.kind == "nothing missing"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("effect", "parameter"),
    [
        (Asymmetry(clutch=0, share=0.25), "asymmetry.share"),
        (ViscousDrag(coordinate=0, coefficient=0.03), "viscous-drag.coefficient"),
    ],
)
def test_what_is_missing_is_named_and_its_size_found(effect, parameter, tmp_path):
    found = diagnose(recorded_axis(tmp_path, [effect]), declared_axis())
    name, field = parameter.split(".")
    assert found.search.verdict.accepted.candidate.name == name
    assert len(found.search.corrected.effects) == 1
    # Noise of 0.2 mrad in 4 s of positions: some 0.1 per cent.
    assert found.search.corrected.values[parameter] == pytest.approx(
        getattr(effect, field), rel=5e-3
    )
    # The floor is from three more draws of all noise: a twentieth allows for its scatter.
    assert found.search.corrected.select_error < 1.05 * found.search.floor


@pytest.mark.slow
def test_a_drag_fifteen_times_the_declared_friction_is_within_bounds(tmp_path):
    found = diagnose(recorded_axis(tmp_path, [ViscousDrag(coordinate=0, coefficient=0.3)]),
                     declared_axis())  # fmt: skip
    assert [e.name for e in found.search.corrected.effects] == ["viscous-drag"]
    # Drag hides Coulomb friction almost wholly here: its per cent shows up in the drag.
    assert found.search.corrected.values["viscous-drag.coefficient"] == pytest.approx(0.3, rel=0.01)
