"""What a driver was told is exact; in a sensor's unit it may have been measured."""

from types import SimpleNamespace as Named

import pytest

from simpter_hybrid.identification.axis.recorded import taken_as_exact


@pytest.mark.parametrize(
    ("unit", "noise", "remarked"),
    [("A", None, True), ("mA", None, True), ("lbf*in", None, True), ("A", 0.01, False),
     ("V", None, False), ("1", None, False)],
)  # fmt: skip
def test_only_without_its_noise_and_in_such_a_unit(unit, noise, remarked):
    drive = Named(unit=unit, noise=noise, column="i")
    found = taken_as_exact(Named(channels={"drive": drive}))
    assert bool(found) == remarked
    assert not any(f.fatal for f in found)
    assert taken_as_exact(Named(channels={"current": drive})) == ()
