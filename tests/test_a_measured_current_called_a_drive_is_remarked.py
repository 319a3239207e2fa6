"""What a driver was told is exact; in a sensor's unit it may have been measured."""

from types import SimpleNamespace as Named

import numpy as np
import pytest

from simpter_hybrid.identification.axis.recorded import taken_as_exact
from simpter_hybrid.identification.recordings.channel_map import ChannelMap


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


@pytest.mark.parametrize(
    ("noise", "stated", "remarked"), [(0.03, None, True), (0.03, 0.03, False), (0.0, None, False)]
)
def test_a_supply_that_was_measured_has_noise_too(noise, stated, remarked):
    volts = 12.0 + noise * np.random.default_rng(1).standard_normal(500)
    supply = ChannelMap("supply", "volts", "V", "input", noise=stated)
    runs = [Named(channels={"supply": volts})]
    assert bool(taken_as_exact(Named(channels={"supply": supply}, runs=runs))) == remarked
