import numpy as np
import pytest

from simpter_hybrid.identification.axis.experiments import axis_experiments
from simpter_hybrid.identification.axis.plan import axis_reach
from simpter_hybrid.identification.axis.told_plan import motion_reach
from simpter_hybrid.identification.fitting.replay import Replay

TIME = 2e-3 * np.arange(4000)


def replay(speed: np.ndarray, drive: np.ndarray) -> Replay:
    notes = {"position": np.cumsum(speed) * 2e-3, "speed": speed}
    return Replay("r", "r", TIME, {"drive": drive}, {}, notes=notes)


def one_stroke() -> Replay:
    """Of 0.6 s in 8 s; the quantiles of its speed and of its drive are 0."""
    inside = (TIME > 2.0) & (TIME < 2.6)
    return replay(np.where(inside, 0.1, 0.0), np.where(inside & (TIME < 2.05), 5.0, 0.0))


def undriven() -> Replay:
    return replay(0.5 * np.exp(-TIME), np.zeros(TIME.size))


@pytest.mark.parametrize("run", [one_stroke(), undriven()], ids=["one stroke", "undriven"])
def test_an_axis_that_mostly_rests_is_planned_as_it_moved(run: Replay) -> None:
    for reach in (axis_reach([run], 2.0, 1.0), motion_reach([run], 2.0)):
        assert reach.high > reach.low
        assert reach.speed > 0.0
        assert reach.force > 0.0
        for name, course in axis_experiments(reach).items():
            assert np.isfinite(course).all(), name
            assert np.ptp(course) > 0.0, name


def test_the_reach_of_one_stroke_is_that_stroke() -> None:
    reach = axis_reach([one_stroke()], 2.0, 3.0)
    assert reach.speed == pytest.approx(0.1)
    assert reach.force == pytest.approx(15.0)
    assert reach.high - reach.low == pytest.approx(np.ptp(one_stroke().notes["position"]))
