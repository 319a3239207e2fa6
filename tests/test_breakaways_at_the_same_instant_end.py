"""Two blocks that share nothing and let go (or stop) at one instant do not disturb each other."""

import pytest
from devices_for_tests import Ramp, TwoBlocks, always_on

from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

#: Ramp and strength of both blocks: in binary fractions, and in ones that do not come out even.
PAIRS = [(1.0, 1.0, 1.0, 1.0), (0.7, 1.0, 0.7, 1.0), (0.7, 1.0, 0.77, 1.1), (0.3, 1.3, -0.3, 1.3)]


def run_of(first, strength, second, other, gap):
    rates = enumerate((first, second))
    loads = tuple(Ramp(float(j), ((0.0, 0.0), (9.0, 9.0 * r))) for j, r in rates)
    clutches = (always_on(strength, gap * strength), always_on(other, gap * other))
    on = {"command": (1.0, 1.0), "excitation": (1.0, 1.0)}
    return Scenario("pair", TwoBlocks(), clutches, (0.0, 0.0), (0.0, 0.0), 6.0, loads=loads, **on)


@pytest.mark.parametrize("gap", [1.0, 1.2])
@pytest.mark.parametrize("pair", PAIRS)
def test_both_let_go(pair, gap):
    trajectory = simulate(run_of(*pair, gap))
    assert trajectory.status == "finished", trajectory.message
    assert abs(trajectory.mode[-1]).tolist() == [1, 1]
    for j, (rate, strength) in enumerate((pair[:2], pair[2:])):
        begin, rest = gap * strength / abs(rate), 6.0 - gap * strength / abs(rate)
        push = abs(rate) * begin - strength
        travel = (push * rest**2 / 2 + abs(rate) * rest**3 / 6) * (1 if rate > 0 else -1)
        assert trajectory.end[j] == pytest.approx(travel, rel=1e-12)


def test_both_stop_and_both_hold_up_to_their_breakaway_torque():
    """Stopped by a push back that only the breakaway torque can hold: both have just arrived."""
    loads = tuple(Ramp(float(j), ((0.0, -1.1), (9.0, -1.1))) for j in range(2))
    on = {"command": (1.0, 1.0), "excitation": (1.0, 1.0)}
    clutches = (always_on(1.0, 1.5), always_on(1.0, 1.5))
    run = Scenario("pair", TwoBlocks(), clutches, (0.0, 0.0), (0.3, 0.3), 1.0, loads=loads, **on)
    trajectory = simulate(run)
    assert trajectory.mode[-1].tolist() == [0, 0]
    stops = [e.t for e in trajectory.events if e.t > 0]
    assert stops == pytest.approx([0.3 / 2.1] * len(stops), abs=1e-12)
