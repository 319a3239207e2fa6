"""All declared numbers by one factor are what a sensor or a drive of another gain does."""

import pytest
from refitted import found

from simpter_hybrid.identification.reporting.refits import one_factor_text


@pytest.mark.parametrize(("mass", "friction"), [(1.12, 1.125), (1.06, 1.065), (0.94, 0.93)])
def test_it_is_what_a_sensor_or_a_drive_of_another_gain_does(mass, friction):
    said = one_factor_text(found(mass, friction))
    assert f"by one factor, {(mass + friction) / 2:.3g}: a force or torque sensor" in said
    # Unless such a sensor was found: then it is no question.
    assert one_factor_text(found(mass, friction, ports=("sensor",))) == ""


@pytest.mark.parametrize(
    ("mass", "friction"),
    [(1.04, 1.045), (1.12, 1.2), (1.0, 1.45), (1.5, 1.5)],  # the last as far as is tried
)
def test_within_all_tolerances_by_two_factors_or_at_their_ends_it_is_not_said(mass, friction):
    assert one_factor_text(found(mass, friction)) == ""


def test_of_what_is_let_alone_it_is_what_another_inertia_does():
    said = one_factor_text(found(1.12, 1.125, driven=False))
    assert "an inertia of another size would look the same" in said
    assert "sensor" not in said
    # What a known weight pulls back shows its inertia.
    assert one_factor_text(found(1.12, 1.125, driven=False, weight=9.0)) == ""
