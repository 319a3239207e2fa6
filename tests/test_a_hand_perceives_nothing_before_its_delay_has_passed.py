"""A late signal is 0 up to its delay, at the first sample too; then it is that of before."""

import pytest

from simpter_hybrid import run
from simpter_hybrid.controllers.hand import late
from simpter_hybrid.rigs import in_place

PERIOD = 0.01


def heard(delay, samples=5):
    mem = [0.0] * 64
    passed = [0.0, *[PERIOD] * (samples - 1)]
    return [late(mem, 0, k, 5.0 + k, delay, passed[k]) for k in range(samples)]


def test_a_late_signal():
    assert heard(2 * PERIOD) == [0.0, 0.0, 5.0, 6.0, 7.0]
    assert heard(0.0) == [5.0, 6.0, 7.0, 8.0, 9.0]


@pytest.mark.parametrize("engine", ["reference", "compiled"])
def test_a_hand_without_a_lag_pushes_at_once_with_all_that_it_wants(engine):
    if engine == "compiled":
        pytest.importorskip("llvmlite")
    asked = in_place.moving(((0.0, 0.0),), 8.0, 0.015)
    (hand, every), *others = asked.controllers
    hand = type(hand)(hand.speed, hand.gain, hand.integral_gain, hand.delay, lag=0.0)
    made = run(asked.replace(controllers=((hand, every), *others)), engine=engine)
    first, second = (made.held[made.segment_at(t)] for t in (0.001, 0.011))
    assert first.any()
    # It starts at the wanted speed, which it does not know yet: only its integral has grown.
    assert abs(second - first).max() < 0.1 * abs(first).max()
