"""A check of what is not known fails; it does not pass in silence."""

from types import SimpleNamespace

from simpter_hybrid.comparison.bounds import exceeded


def test_a_device_without_a_potential_breaks_a_bound_on_energy():
    row = SimpleNamespace(name="band", status="finished", energy_created=None)
    (found,) = exceeded(SimpleNamespace(rows=[row]), {"energy_created": 1.0})
    assert str(found) == (
        "band: the device does not tell its potential energy, so energy_created has no value to "
        "bound"
    )
