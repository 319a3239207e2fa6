from dataclasses import replace

import numpy as np
import pytest
from evidence import judged

from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Trial, share
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.tracing.limits import REPEATED, SIMULATED_AXIS, Limits
from simpter_hybrid.identification.tracing.rivals import best_form
from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.identification.tracing.verdict import Verdict, conclude

BEFORE, FLOOR = 1.5, 1.0


def _trial(name, select, family=None, coordinates=("x",), parameters=1):
    own = tuple(Parameter(f"p{k}", 0.0, -1.0, 1.0, 0.1) for k in range(parameters))
    candidate = Candidate(
        name, own, ((0.0,) * parameters,), family or name, "friction", coordinates
    )
    fit = Fit({}, 0.0, np.empty((0, 0)), np.empty(0), 0)
    return Trial(candidate, fit, select, 1 - select / BEFORE, share(BEFORE, select, FLOOR))


def _depends(name, gain, p_value=0.005):
    nothing = np.empty(0)
    return Dependence(name, gain, p_value, 1000, nothing, nothing, nothing)


@pytest.mark.parametrize(
    ("trials", "before", "after", "kind"),
    [
        ([_trial("a", 1.49)], [_depends("x", 0.001)], [], "nothing missing"),
        ([_trial("a", 1.49)], [_depends("x", 0.2)], [_depends("x", 0.2)], "unknown"),
        ([_trial("a", 1.0)], [_depends("x", 0.3)], [_depends("x", 0.001)], "effect"),
        ([_trial("a", 1.4)], [_depends("y", 0.3)], [_depends("y", 0.2)], "unknown"),
        ([_trial("a", 1.2)], [_depends("x", 0.3)], [_depends("y", 0.2)], "open"),
        (
            [_trial("a", 1.2)],
            [_depends("x", 0.3)],
            [_depends("y", 0.2), _depends("x", 0.17)],
            "open",
        ),
        (
            [_trial("a", 1.2)],
            [_depends("x", 0.3)],
            [_depends("y", 0.2), _depends("x", 0.19)],
            "form incomplete",
        ),
        (
            [_trial("a", 1.2, coordinates=("friction:time",))],
            [_depends("friction:time", 0.3)],
            [_depends("friction:distance", 0.2)],
            "open",
        ),
        ([_trial("a", 1.1)], [_depends("x", 0.3)], [_depends("x", 0.1)], "form incomplete"),
        ([_trial("a", 1.06)], [_depends("x", 0.3)], [], "form incomplete"),
        # Much is left of which only the spread depends on anything.
        ([_trial("a", 1.3)], [_depends("x", 0.3)], [], "open"),
        ([_trial("a", 1.3)], [_depends("x", 0.3)], [_depends("vibration:y", 0.2)], "open"),
        (
            [_trial("a", 1.25)],
            [_depends("x", 0.3)],
            [_depends("vibration:y", 0.2), _depends("vibration:x", 0.19)],
            "form incomplete",
        ),
        (
            [_trial("a", 1.3)],  # leaves more than half
            [_depends("x", 0.3)],
            [_depends("vibration:y", 0.2), _depends("vibration:x", 0.19)],
            "open",
        ),
        ([_trial("a", 1.0), _trial("b", 1.02)], [_depends("x", 0.3)], [], "cannot be told apart"),
        ([_trial("a", 1.0), _trial("b", 1.025)], [_depends("x", 0.3)], [], "effect"),
        ([_trial("a", 1.08), _trial("b", 1.1)], [_depends("x", 0.3)], [], "cannot be told apart"),
    ],
)
def test_each_case(trials, before, after, kind):
    assert judged(trials, before, after, FLOOR, ratio=1.02).kind == kind


def test_the_simplest_form_of_a_family_is_preferred_where_it_is_as_good():
    plain, rich = _trial("one", 1.105, "f"), _trial("two", 1.1, "f", parameters=3)
    assert best_form([plain, rich]) is plain
    worse = _trial("one", 1.2, "f")
    assert best_form([worse, rich]) is rich


def test_an_unknown_names_the_variable():
    before = [_depends("angle", 0.2), _depends("w", 0.01)]
    verdict = judged([_trial("a", 1.49)], before, [], FLOOR, ratio=1.5)
    assert verdict.coordinates == ("angle",)


@pytest.mark.parametrize(
    ("later", "share_of_all", "kind"),
    [
        ([Verdict("effect", _trial("b", 1.0))], 0.99, "effect"),
        ([Verdict("unknown", None, (), ("y",))], 0.6, "unknown"),
        ([], 0.6, "unknown"),
    ],
)
def test_an_open_round_is_closed_by_what_follows(later, share_of_all, kind):
    first = Verdict("open", _trial("a", 1.2), (), ("y",))
    assert conclude([first, *later], share_of_all, 1.0).kind == kind


@pytest.mark.parametrize(
    ("rounds", "ratio", "kind"),
    [
        ([Verdict("form incomplete", _trial("a", 1.2)), Verdict("effect", _trial("b", 1.0))], 1.0,
         "effect"),
        ([Verdict("form incomplete", _trial("a", 1.2)), Verdict("effect", _trial("b", 1.0))], 1.07,
         "form incomplete"),
        ([Verdict("effect", _trial("a", 1.2)),
          Verdict("cannot be told apart", _trial("b", 1.0), (_trial("c", 1.0),))], 1.0,
         "cannot be told apart"),
        ([Verdict("cannot be told apart", _trial("a", 1.2), (_trial("b", 1.0),)),
          Verdict("effect", _trial("b", 1.0))], 1.0, "effect"),
        ([Verdict("effect", _trial("a", 1.2)),
          Verdict("effect", _trial("b", 1.0), (), (), ("friction:run",))], 1.0,
         "cannot be told apart"),
    ],
)  # fmt: skip
def test_doubts_of_every_round_reach_the_verdict(rounds, ratio, kind):
    assert conclude(rounds, 0.99, ratio).kind == kind


@pytest.mark.parametrize(
    ("where", "kind"), [("load:heat", "nothing missing"), ("breakaway:rest", "unknown")]
)
def test_at_the_floor_only_breakaway_tells(where, kind):
    assert judged([], [_depends(where, 0.6)], [], FLOOR, ratio=0.99).kind == kind


@pytest.mark.parametrize(
    ("also", "where"), [([], ("vibration:since_rest",)), ([_depends("f:x", 0.2)], ("f:x",))]
)
def test_a_vibration_is_named_only_where_no_force_depends_on_anything(also, where):
    before = [_depends("vibration:since_rest", 0.008), *also]
    assert judged([], before, [], FLOOR, ratio=1.2).coordinates == where
    assert judged([], before[:1], [], FLOOR, ratio=1.02).kind == "nothing missing"


def test_what_is_on_no_coordinate_is_said_in_order():
    rings, slow = _depends("ringing:breakaway", 0.95), _depends("friction:run", 0.5)
    spread = _depends("vibration:since_rest", 0.008)
    for before, where in (
        ([spread, slow, rings], rings),
        ([spread, slow], slow),
        ([rings, _depends("f:x", 0.2)], _depends("f:x", 0.2)),
    ):
        assert judged([], before, [], FLOOR, ratio=1.2).coordinates == (where.coordinate,)


def test_a_slow_state_goes_before_what_a_candidate_leaves():
    best, slow = [_trial("a", 1.4)], _depends("friction:run", 0.5)
    left, spread = [_depends("f:y", 0.2)], _depends("vibration:since_rest", 0.008)
    assert judged(best, [slow], left, FLOOR, ratio=1.5).coordinates == ("friction:run",)
    assert judged(best, [spread], left, FLOOR, ratio=1.5).coordinates == ("f:y",)


def test_at_the_floor_a_ringing_tells_and_a_slow_state_does_not():
    assert judged([], [_depends("ringing:breakaway", 0.95)], [], FLOOR, ratio=1.0).kind == "unknown"
    assert judged([], [_depends("friction:run", 0.5)], [], FLOOR, ratio=1.0).kind != "unknown"


@pytest.mark.parametrize(
    ("gain", "named"),
    [(0.04, ("friction:run", "load:speed")), (0.4, ("friction:position", "load:speed"))],
)
def test_beside_a_slow_state_a_coordinate_that_does_far_less_is_chance(gain, named):
    before = [
        _depends("friction:run", 0.87), _depends("load:speed", 0.1),
        _depends("friction:position", gain),
    ]  # fmt: skip
    poor = _trial("a", 1.45)
    for trials in ([], [poor]):
        assert set(judged(trials, before, [], FLOOR, ratio=1.5).coordinates) == set(named)


@pytest.mark.parametrize(
    ("trials", "after", "kind"),
    [
        ([_trial("a", 1.0, coordinates=("f:time",))], [], "effect"),
        ([_trial("a", 1.0, coordinates=("f:time",)), _trial("b", 1.025)], [], "contested"),
        ([_trial("a", 1.05, coordinates=("f:time",))], [_depends("f:heat", 0.1)], "contested"),
        ([_trial("a", 1.2, coordinates=("f:time",))], [_depends("f:heat", 0.1)], "open"),
    ],
)
def test_on_one_way_runs_nothing_that_grows_along_is_excused(trials, after, kind):
    said = judged(trials, [_depends("f:time", 0.3)], after, FLOOR, ratio=1.5, one_way=True)
    assert said.kind == {"contested": "cannot be told apart"}.get(kind, kind)


@pytest.mark.parametrize(("one_way", "kind"), [(True, "open"), (False, "form incomplete")])
def test_far_above_the_floor_a_name_on_one_way_runs_must_explain_nearly_all(one_way, kind):
    # From 10 to 4 times the floor is 0.85 of the lack.
    trial = replace(_trial("a", 4.0 * FLOOR, coordinates=("f:speed",)), share=0.85, gain=0.5)
    left = [_depends("f:speed", 0.3)]
    assert judged([trial], left, left, FLOOR, ratio=10.0, one_way=one_way).kind == kind


def test_patches_that_leave_much_do_not_close_an_open_round():
    patches = [Verdict("open", _trial("a", 1.3)), Verdict("effect", _trial("b", 1.25))]
    assert conclude(patches, 0.6, 1.25).kind == "unknown"
    assert conclude(patches, 0.8, 1.15).kind == "form incomplete"


def test_effects_that_are_all_open_name_nothing_however_much_they_explain():
    patches = [Verdict("open", _trial(name, 1.3), (), ("f:heat",)) for name in "abc"]
    said = conclude(patches, 0.95, 1.05, ["f:time"])
    assert (said.kind, said.coordinates) == ("unknown", ("f:time",))
    closed = [*patches, Verdict("form incomplete", _trial("d", 1.1))]
    assert conclude(closed, 0.95, 1.25).kind == "form incomplete"


@pytest.mark.parametrize(
    ("left", "kind"), [(["f:x"], "form incomplete"), (["f:x", "f:y"], "open"), ([], "effect")]
)
def test_what_an_earlier_effect_leaves_on_its_own_coordinate_is_not_foreign(left, kind):
    second = [_trial("b", 1.2 if left else 1.0, coordinates=("load:x",))]
    after = [_depends(where, 0.1) for where in left]
    said = judged(second, [_depends("load:x", 0.3)], after, FLOOR, ratio=1.5, found=["f:x"])
    assert said.kind == kind


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
    half = [_trial("a", error, coordinates=("f:x",))]
    after = [_depends(where, 0.1) for where in left]
    assert judged(half, [_depends("f:x", 0.3)], after, FLOOR, ratio=1.5).kind == kind


def test_what_is_noise_depends_on_how_the_floor_is_known():
    found = [_trial("a", 1.3)]
    assert judged(found, [], [], FLOOR, ratio=1.5).kind == "open"
    single = Limits(lack=1.5, form=1.5)
    said = judged(found, [], [], FLOOR, ratio=1.5, limit=single)
    assert said.kind == "effect"
    assert conclude([said], 0.4, 1.3, limit=single).kind == "effect"
    assert judged([], [], [], FLOOR, ratio=1.4, limit=single).kind == "nothing missing"
    assert judged([], [], [], FLOOR, ratio=1.6, limit=single).kind == "unknown"


def test_what_explains_little_of_what_may_be_noise_is_no_lack():
    little = [_trial("a", 1.4)]  # 0.23 of what lies above the floor
    single = Limits(lack=1.5, form=1.5)
    assert judged(little, [], [], FLOOR, ratio=1.45, limit=single).kind == "nothing missing"
    assert judged(little, [], [], FLOOR, ratio=1.45).kind == "unknown"
    depends = [_depends("y", 0.3)]
    assert judged(little, depends, [], FLOOR, ratio=1.45, limit=single).kind == "unknown"


@pytest.mark.parametrize(("gain", "kind"), [(0.06, "nothing missing"), (0.2, "unknown")])
def test_a_weak_dependence_tells_of_nothing_where_an_axis_was_not_run_again(gain, kind):
    assert (
        judged([], [_depends("x", gain)], [], FLOOR, ratio=1.1, limit=SIMULATED_AXIS).kind == kind
    )
    assert judged([], [_depends("x", gain)], [], FLOOR, ratio=1.1).kind == "unknown"
    certain = judged([], [_depends("x", gain)], [], FLOOR, ratio=2.0, limit=SIMULATED_AXIS)
    assert (certain.kind, certain.coordinates) == ("unknown", ("x",))


@pytest.mark.parametrize(
    ("limit", "left", "kind"),
    [
        (SIMULATED_AXIS, [], "effect"),
        (SIMULATED_AXIS, [_depends("x", 0.2)], "cannot be told apart"),
        (REPEATED, [_depends("x", 0.2)], "form incomplete"),  # repeated runs tell the floor
    ],
)
def test_at_an_estimated_floor_a_rival_is_not_excluded_by_a_form_that_leaves_something(
    limit, left, kind
):
    trials = [_trial("a", 0.98), _trial("b", 1.09)]
    assert judged(trials, [_depends("x", 0.3)], left, FLOOR, ratio=1.5, limit=limit).kind == kind


@pytest.mark.parametrize(("ratio", "where"), [(7.6, ("f:torque", "f:x")), (1.4, ("f:torque",))])
def test_where_something_is_missing_for_certain_a_weaker_dependence_tells_too(ratio, where):
    before = [_depends("f:torque", 0.109), _depends("f:x", 0.089)]
    assert judged([], before, [], FLOOR, ratio=ratio, limit=SIMULATED_AXIS).coordinates == where


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
    trial = replace(_trial("a", select), share=part)
    assert judged([trial], [], [], FLOOR, ratio=1.25, found=found).kind == kind
