"""A limit is where a ramp ends; a load that does not rise never gets there."""

import pytest

from simpter_hybrid.loads.ramp import RampOnCoordinate


@pytest.mark.parametrize("limit", [3.0, 8.0])
@pytest.mark.parametrize("time", [0.0, 2.0])
def test_before_and_after_its_start(limit, time):
    load = RampOnCoordinate(base=5.0, slope=0.0, start=1.0, limit=limit)
    forces = [0.0]
    load.force(time, forces, **load.parameters())
    assert forces == [5.0]
