"""A ramp leads either way; without a limit it has no end, and away from a limit it is refused."""

import math

import pytest
from devices_for_tests import always_on

from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.engine import simulate
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.scenario import Scenario


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("limit", [None, 3.0])
def test_the_same_speed_either_way(way, limit):
    given = {} if limit is None else {"limit": way * limit}
    load = RampOnCoordinate(base=way, slope=2.0 * way, start=0.5, **given)
    found = simulate(Scenario(
        "axis", LinearAxis(mass=1.0), (always_on(1.0, 1.0),), (0.0,), (0.0,), 2.5, loads=(load,)
    ))  # fmt: skip
    # 1 N for 0.5 s, then 1 + 2 t N for 2 s; with a limit 3 N is reached half-way.
    impulse = 0.5 + (6.0 if limit is None else 2.0 + 3.0)
    assert found.end[1] == pytest.approx(way * impulse, rel=1e-9)


@pytest.mark.parametrize(
    ("slope", "limit", "side"),
    [(2.0, 0.5, "above"), (2.0, -math.inf, "above"), (-2.0, 1.5, "below")],
)
def test_a_limit_on_the_wrong_side_is_refused(slope, limit, side):
    with pytest.raises(ValueError, match=f"limit: .* is not {side} the base, 1"):
        RampOnCoordinate(base=1.0, slope=slope, limit=limit)
