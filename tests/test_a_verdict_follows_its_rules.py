from dataclasses import replace

import pytest
from evidence import FLOOR, depends, judged, trial

from simpter_hybrid.identification.tracing.conclusion import conclude
from simpter_hybrid.identification.tracing.limits import (
    REPEATED,
    SIMULATED,
    SIMULATED_AXIS,
    Limits,
)
from simpter_hybrid.identification.tracing.rivals import best_form


@pytest.mark.parametrize(
    ("trials", "before", "after", "kind"),
    [
        ([trial("a", 1.49)], [depends("x", 0.001)], [], "nothing missing"),
        ([trial("a", 1.49)], [depends("x", 0.2)], [depends("x", 0.2)], "unknown"),
        ([trial("a", 1.0)], [depends("x", 0.3)], [depends("x", 0.001)], "effect"),
        ([trial("a", 1.4)], [depends("y", 0.3)], [depends("y", 0.2)], "unknown"),
        ([trial("a", 1.2)], [depends("x", 0.3)], [depends("y", 0.2)], "open"),
        (
            [trial("a", 1.2)],
            [depends("x", 0.3)],
            [depends("y", 0.2), depends("x", 0.17)],
            "open",
        ),
        (
            [trial("a", 1.2)],
            [depends("x", 0.3)],
            [depends("y", 0.2), depends("x", 0.19)],
            "form incomplete",
        ),
        (
            [trial("a", 1.2, coordinates=("friction:time",))],
            [depends("friction:time", 0.3)],
            [depends("friction:distance", 0.2)],
            "open",
        ),
        ([trial("a", 1.1)], [depends("x", 0.3)], [depends("x", 0.1)], "form incomplete"),
        ([trial("a", 1.06)], [depends("x", 0.3)], [], "form incomplete"),
        # Much is left of which only the spread depends on anything.
        ([trial("a", 1.3)], [depends("x", 0.3)], [], "open"),
        ([trial("a", 1.3)], [depends("x", 0.3)], [depends("vibration:y", 0.2)], "open"),
        (
            [trial("a", 1.25)],
            [depends("x", 0.3)],
            [depends("vibration:y", 0.2), depends("vibration:x", 0.19)],
            "form incomplete",
        ),
        (
            [trial("a", 1.3)],  # leaves more than half
            [depends("x", 0.3)],
            [depends("vibration:y", 0.2), depends("vibration:x", 0.19)],
            "open",
        ),
        ([trial("a", 1.0), trial("b", 1.02)], [depends("x", 0.3)], [], "cannot be told apart"),
        ([trial("a", 1.0), trial("b", 1.025)], [depends("x", 0.3)], [], "effect"),
        ([trial("a", 1.08), trial("b", 1.1)], [depends("x", 0.3)], [], "cannot be told apart"),
    ],
)
def test_each_case(trials, before, after, kind):
    assert judged(trials, before, after, FLOOR, ratio=1.02).kind == kind


def test_the_simplest_form_of_a_family_is_preferred_where_it_is_as_good():
    plain, rich = trial("one", 1.105, "f"), trial("two", 1.1, "f", parameters=3)
    assert best_form([plain, rich]) is plain
    worse = trial("one", 1.2, "f")
    assert best_form([worse, rich]) is rich


def test_a_form_that_contains_another_must_pay_for_what_it_has_more():
    push = trial("push", 1.105, "push", parameters=2)
    spring = trial("spring", 1.1, "spring", parameters=3)
    spring = replace(spring, candidate=replace(spring.candidate, contains=("push",)))
    assert best_form([push, spring]) is push
    stiff = replace(spring, select_error=1.05)
    assert best_form([push, stiff]) is stiff


def test_an_unknown_names_the_variable():
    before = [depends("angle", 0.2), depends("w", 0.01)]
    verdict = judged([trial("a", 1.49)], before, [], FLOOR, ratio=1.5)
    assert verdict.coordinates == ("angle",)


@pytest.mark.parametrize(
    ("ratio", "limit", "kind"),
    [
        (1.1, SIMULATED_AXIS, "nothing missing"),
        (1.22, SIMULATED_AXIS, "lack or noise"),
        (1.6, SIMULATED_AXIS, "lack or noise"),
        (10.5, SIMULATED_AXIS, "unknown"),
        (1.22, REPEATED, "unknown"),
    ],
)
def test_what_helps_a_little_where_the_floor_is_simulated_is_no_lack(ratio, limit, kind):
    weak = [depends("x", 0.001, 0.9)]
    assert judged([trial("a", 1.44)], weak, weak, FLOOR, ratio=ratio, limit=limit).kind == kind


@pytest.mark.parametrize(
    ("trials", "after", "kind"),
    [
        ([trial("a", 1.0, coordinates=("f:time",))], [], "effect"),
        ([trial("a", 1.0, coordinates=("f:time",)), trial("b", 1.025)], [], "contested"),
        ([trial("a", 1.05, coordinates=("f:time",))], [depends("f:heat", 0.1)], "contested"),
        ([trial("a", 1.2, coordinates=("f:time",))], [depends("f:heat", 0.1)], "open"),
    ],
)
def test_on_one_way_runs_nothing_that_grows_along_is_excused(trials, after, kind):
    said = judged(trials, [depends("f:time", 0.3)], after, FLOOR, ratio=1.5, one_way=True)
    assert said.kind == {"contested": "cannot be told apart"}.get(kind, kind)


@pytest.mark.parametrize(("error", "one_way"), [(1.08, True), (1.08, False), (1.0, True)])
def test_on_one_way_runs_a_form_that_is_not_right_is_no_name(error, one_way):
    # The drift that stood for a sagging supply, a command's offset for an asymmetry.
    named = trial("a", error * FLOOR, coordinates=("f:time",))
    left = [depends("f:time", 0.1)]
    said = judged([named], [depends("f:time", 0.3)], left, FLOOR, ratio=1.9, one_way=one_way)
    vague = error > 1.05 and one_way
    assert (said.kind == "cannot be told apart") == vague
    assert said.as_well == (("f:time",) if vague else ())


@pytest.mark.parametrize(
    ("share", "one_way", "kind"),
    [(0.85, True, "open"), (0.85, False, "form incomplete"), (0.75, False, "open")],
)
def test_far_above_the_floor_a_name_must_explain_more_and_of_one_way_runs_nearly_all(
    share, one_way, kind
):
    # From 10 to 4 times the floor is 0.85 of the lack.
    named = replace(trial("a", 4.0 * FLOOR, coordinates=("f:speed",)), share=share, gain=0.5)
    left = [depends("f:speed", 0.3)]
    assert judged([named], left, left, FLOOR, ratio=10.0, one_way=one_way).kind == kind


@pytest.mark.parametrize(
    ("left", "kind"), [(["f:x"], "form incomplete"), (["f:x", "f:y"], "open"), ([], "effect")]
)
def test_what_an_earlier_effect_leaves_on_its_own_coordinate_is_not_foreign(left, kind):
    second = [trial("b", 1.2 if left else 1.0, coordinates=("load:x",))]
    after = [depends(where, 0.1) for where in left]
    said = judged(second, [depends("load:x", 0.3)], after, FLOOR, ratio=1.5, found=["f:x"])
    assert said.kind == kind


@pytest.mark.parametrize(("balance", "kind"), [("breakaway", "form incomplete"), ("load", "open")])
def test_what_friction_leaves_in_the_drives_balance_too_is_foreign(balance, kind):
    # It does not change what the drive gives beside what the clutch is read to take: a sensor does.
    most = [trial("a", 1.18, coordinates=("friction:x",))]
    after = [depends("friction:x", 0.1), depends(f"{balance}:x", 0.1)]
    assert judged(most, [depends("friction:x", 0.3)], after, FLOOR, ratio=1.5).kind == kind


@pytest.mark.parametrize(
    ("error", "left", "kind"),
    [
        (1.3, [], "open"),
        (1.25, ["f:x"], "form incomplete"),
        (1.15, [], "form incomplete"),
        (1.3, ["f:x"], "open"),
    ],
)
def test_where_much_is_left_but_not_on_its_own_coordinate_an_effect_is_not_named(error, left, kind):
    half = [trial("a", error, coordinates=("f:x",))]
    after = [depends(where, 0.1) for where in left]
    assert judged(half, [depends("f:x", 0.3)], after, FLOOR, ratio=1.5).kind == kind


def test_what_is_noise_depends_on_how_the_floor_is_known():
    found = [trial("a", 1.3)]
    assert judged(found, [], [], FLOOR, ratio=1.5).kind == "open"
    single = Limits(lack=1.5, form=1.5)
    said = judged(found, [], [], FLOOR, ratio=1.5, limit=single)
    assert said.kind == "effect"
    assert conclude([said], 0.4, 1.3, limit=single).kind == "effect"
    assert judged([], [], [], FLOOR, ratio=1.4, limit=single).kind == "nothing missing"
    assert judged([], [], [], FLOOR, ratio=1.6, limit=single).kind == "unknown"


def test_what_explains_little_of_what_may_be_noise_is_no_lack():
    little = [trial("a", 1.4)]  # 0.23 of what lies above the floor
    single = Limits(lack=1.5, form=1.5)
    assert judged(little, [], [], FLOOR, ratio=1.45, limit=single).kind == "nothing missing"
    assert judged(little, [], [], FLOOR, ratio=1.45).kind == "unknown"
    before = [depends("y", 0.3)]
    assert judged(little, before, [], FLOOR, ratio=1.45, limit=single).kind == "unknown"


@pytest.mark.parametrize(
    ("limit", "after", "kind"),
    [
        (SIMULATED, 1.02, "effect"),  # a robot's few blocks depend on this and that by chance
        (SIMULATED, 1.04, "form incomplete"),
        (REPEATED, 1.0, "form incomplete"),
    ],
)
def test_a_form_that_leaves_something_near_the_floor_is_incomplete_where_that_is_no_chance(
    limit, after, kind
):
    left = [depends("x", 0.05)]
    trials = [trial("a", after * FLOOR)]
    assert judged(trials, [depends("x", 0.3)], left, FLOOR, ratio=1.5, limit=limit).kind == kind


@pytest.mark.parametrize(
    ("limit", "left", "kind"),
    [
        (SIMULATED_AXIS, [], "effect"),
        (SIMULATED_AXIS, [depends("x", 0.2)], "cannot be told apart"),
        (REPEATED, [depends("x", 0.2)], "form incomplete"),  # repeated runs tell the floor
    ],
)
def test_at_an_estimated_floor_a_rival_is_not_excluded_by_a_form_that_leaves_something(
    limit, left, kind
):
    trials = [trial("a", 0.98), trial("b", 1.09)]
    assert judged(trials, [depends("x", 0.3)], left, FLOOR, ratio=1.5, limit=limit).kind == kind


@pytest.mark.parametrize(
    ("part", "select", "found", "kind"),
    [
        (0.55, 1.15, (), "form incomplete"),
        (0.45, 1.15, (), "open"),
        (0.45, 1.15, ("f:x",), "form incomplete"),
        (0.45, 1.04, (), "effect"),
    ],
)
def test_a_first_effect_that_leaves_more_than_half_needs_others_beside_it(
    part, select, found, kind
):
    lone = replace(trial("a", select), share=part)
    assert judged([lone], [], [], FLOOR, ratio=1.25, found=found).kind == kind


def test_what_does_not_only_go_by_what_grows_is_no_such_effect():
    force = [trial("a", 1.15, coordinates=("f:time", "f:position"))]
    after = [depends(where, 0.1) for where in ("f:time", "f:heat")]
    said = judged(force, [depends("f:time", 0.3)], after, FLOOR, ratio=1.5)
    assert said.kind == "form incomplete"


@pytest.mark.parametrize("balances", ["f", "fg"])
@pytest.mark.parametrize(
    ("error", "left", "kind"),
    [
        (1.15, ["f:time"], "form incomplete"),
        (1.15, ["f:time", "f:heat"], "open"),
        (1.15, ["f:time", "f:speed"], "form incomplete"),
        (1.05, ["f:time", "f:heat"], "form incomplete"),  # at the floor
    ],
)
def test_what_grows_in_a_run_is_not_told_from_what_grows_along_off_the_floor(
    error, left, kind, balances
):
    own = tuple(f"{balance}:time" for balance in balances)
    slow = [trial("a", error * FLOOR, coordinates=own)]
    after = [depends(where, 0.1) for where in left]
    assert judged(slow, [depends("f:time", 0.3)], after, FLOOR, ratio=1.5).kind == kind
