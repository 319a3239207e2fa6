"""Table 1 of the thesis: where two of PTER's clutches stick, every other applied one does too."""

import pytest

import simpter_hybrid as sh
from simpter_hybrid import engine
from simpter_hybrid.karnopp import FAIR, THESIS, simulate


@pytest.mark.parametrize("rules", [THESIS, FAIR], ids=["thesis", "fair"])
def test_four_clutches_stop_links_that_turn_alike(rules):
    # The two links are as fast as each other: clutches 1, 2 and 3 are inside the band while the
    # slip of clutch 4, the sum of the speeds, is still twice as large.
    four = (5.0, 5.0, 5.0, 5.0)
    scenario = sh.load("line-y24").replace(
        controllers=(), period=0.0, loads=(), stops=(), t_end=0.2, qd=(0.2, 0.2),
        command=four, excitation=four,
    )  # fmt: skip
    locked = (0, 0, 0, 0)
    exact = next(e.t for e in engine.simulate(scenario).events if e.after == locked)
    band = 0.01
    run = simulate(scenario, band=band, rules=rules, max_step=1e-4)
    reached = [e.t for e in run.events if e.after == locked]
    # The links lose 0.2 rad/s until rest: the band is left out of that, and as much again of time.
    assert reached
    assert abs(reached[0] - exact) <= 2.0 * band / 0.2 * exact
