"""Two blocks that let go at one instant are a set in the log, however rounding parts their guards.

By rounding one engine may find both guards down at once, the other one after the other.
"""

import pytest
from devices_for_tests import Ramp, TwoBlocks, always_on

from simpter_hybrid import engine
from simpter_hybrid.explanation.explain import explain, segments_around
from simpter_hybrid.running.recorder import Recorder
from simpter_hybrid.scenario import Scenario


def scenario():
    loads = (Ramp(0.0, ((0.0, 0.0), (1.0, 1.0))), Ramp(1.0, ((0.0, 0.0), (1.0, -1.0))))
    on = {"command": (1.0, 1.0), "excitation": (1.0, 1.0)}
    clutches = (always_on(0.5, 0.5), always_on(0.5, 0.5))
    return Scenario("pair", TwoBlocks(), clutches, (0.0, 0.0), (0.0, 0.0), 1.0, loads=loads, **on)


@pytest.mark.parametrize("name", ["reference", "compiled"])
def test_both_are_in_it_and_the_segments_around_it_are_found(name):
    if name == "compiled":
        pytest.importorskip("llvmlite")
        from simpter_hybrid.compiled import simulate
    else:
        simulate = engine.simulate
    found = simulate(scenario())
    _, let_go = found.events
    assert (let_go.kind, let_go.clutches) == ("breakaway", (1, 2))
    assert (let_go.before, let_go.after) == ((0, 0), (1, -1))
    assert found.statistics["events"] == 2
    before, after = segments_around(found)[1]
    assert found.mode[[before, after]].tolist() == [[0, 0], [1, -1]]
    assert after == len(found.mode) - 1
    assert "took another mode" not in str(explain(found, let_go.t))


def test_of_two_that_follow_one_another_the_first_margin_is_kept():
    recorder = Recorder(scenario())
    _, w = recorder.scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)
    w.mode[:2] = [0, 0]
    for t, mode, margin in ((0.5, [1, 0], -1e-9), (0.5, [1, -1], -2e-9), (0.6, [1, 1], 0.0)):
        before, w.mode[:2] = tuple(w.mode[:2]), mode
        recorder.event(t, "breakaway", before, w, margin=margin)
    told = [(e.t, e.clutches, e.before, e.after, e.margin) for e in recorder.events]
    assert told == [
        (0.5, (1, 2), (0, 0), (1, -1), -1e-9),
        (0.6, (2,), (1, -1), (1, 1), 0.0),
    ]
