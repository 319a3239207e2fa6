"""On which coordinates an unknown is said to depend, and what is asked only where none counts."""

import pytest
from evidence import FLOOR, depends, judged, trial

from simpter_hybrid.identification.tracing.limits import SIMULATED_AXIS


@pytest.mark.parametrize(
    ("where", "kind"), [("load:heat", "nothing missing"), ("breakaway:rest", "unknown")]
)
def test_at_the_floor_only_breakaway_tells(where, kind):
    assert judged([], [depends(where, 0.6)], [], FLOOR, ratio=0.99).kind == kind


@pytest.mark.parametrize(
    ("also", "where"), [([], ("vibration:since_rest",)), ([depends("f:x", 0.2)], ("f:x",))]
)
def test_a_vibration_is_named_only_where_no_force_depends_on_anything(also, where):
    before = [depends("vibration:since_rest", 0.008), *also]
    assert judged([], before, [], FLOOR, ratio=1.2).coordinates == where
    assert judged([], before[:1], [], FLOOR, ratio=1.02).kind == "nothing missing"


def test_what_is_on_no_coordinate_is_said_in_order():
    rings, slow = depends("ringing:breakaway", 0.95), depends("friction:run", 0.5)
    spread = depends("vibration:since_rest", 0.008)
    for before, where in (
        ([spread, slow, rings], rings),
        ([spread, slow], slow),
        ([rings, depends("f:x", 0.2)], depends("f:x", 0.2)),
    ):
        assert judged([], before, [], FLOOR, ratio=1.2).coordinates == (where.coordinate,)


def test_a_slow_state_goes_before_what_a_candidate_leaves():
    best, slow = [trial("a", 1.4)], depends("friction:run", 0.5)
    left, spread = [depends("f:y", 0.2)], depends("vibration:since_rest", 0.008)
    assert judged(best, [slow], left, FLOOR, ratio=1.5).coordinates == ("friction:run",)
    assert judged(best, [spread], left, FLOOR, ratio=1.5).coordinates == ("f:y",)


def test_at_the_floor_a_ringing_tells_and_a_slow_state_does_not():
    assert judged([], [depends("ringing:breakaway", 0.95)], [], FLOOR, ratio=1.0).kind == "unknown"
    assert judged([], [depends("friction:run", 0.5)], [], FLOOR, ratio=1.0).kind != "unknown"


@pytest.mark.parametrize(
    ("gain", "named"),
    [
        (0.04, ("friction:run", "load:speed")),
        (0.4, ("friction:run", "friction:position", "load:speed")),
        (0.6, ("friction:position", "load:speed")),
    ],
)
def test_beside_a_slow_state_a_coordinate_that_does_far_less_is_chance(gain, named):
    before = [
        depends("friction:run", 0.87), depends("load:speed", 0.1),
        depends("friction:position", gain),
    ]  # fmt: skip
    poor = trial("a", 1.45)
    for trials in ([], [poor]):
        assert set(judged(trials, before, [], FLOOR, ratio=1.5).coordinates) == set(named)


@pytest.mark.parametrize(("gain", "kind"), [(0.06, "nothing missing"), (0.2, "unknown")])
def test_a_weak_dependence_tells_of_nothing_where_an_axis_was_not_run_again(gain, kind):
    assert judged([], [depends("x", gain)], [], FLOOR, ratio=1.1, limit=SIMULATED_AXIS).kind == kind
    assert judged([], [depends("x", gain)], [], FLOOR, ratio=1.1).kind == "unknown"
    certain = judged([], [depends("x", gain)], [], FLOOR, ratio=2.0, limit=SIMULATED_AXIS)
    assert (certain.kind, certain.coordinates) == ("unknown", ("x",))


@pytest.mark.parametrize(("ratio", "where"), [(7.6, ("f:torque", "f:x")), (1.4, ("f:torque",))])
def test_where_something_is_missing_for_certain_a_weaker_dependence_tells_too(ratio, where):
    before = [depends("f:torque", 0.109), depends("f:x", 0.089)]
    assert judged([], before, [], FLOOR, ratio=ratio, limit=SIMULATED_AXIS).coordinates == where
