"""What may be said of a whole search, round after round."""

import pytest
from evidence import trial

from simpter_hybrid.identification.tracing.conclusion import conclude
from simpter_hybrid.identification.tracing.limits import REPEATED, SINGLE
from simpter_hybrid.identification.tracing.verdict import Verdict

SPREAD = ("vibration:speed", "ringing:breakaway")


@pytest.mark.parametrize(
    ("later", "share_of_all", "kind"),
    [
        ([Verdict("effect", trial("b", 1.0))], 0.99, "effect"),
        ([Verdict("unknown", None, (), ("y",))], 0.6, "unknown"),
        ([], 0.6, "unknown"),
    ],
)
def test_an_open_round_is_closed_by_what_follows(later, share_of_all, kind):
    first = Verdict("open", trial("a", 1.2), (), ("y",))
    assert conclude([first, *later], share_of_all, 1.0).kind == kind


@pytest.mark.parametrize(
    ("rounds", "ratio", "kind"),
    [
        ([Verdict("form incomplete", trial("a", 1.2)), Verdict("effect", trial("b", 1.0))], 1.0,
         "effect"),
        ([Verdict("form incomplete", trial("a", 1.2)), Verdict("effect", trial("b", 1.0))], 1.07,
         "form incomplete"),
        ([Verdict("effect", trial("a", 1.2)),
          Verdict("form incomplete", trial("b", 1.0), (), ("y",))], 1.0, "form incomplete"),
        ([Verdict("effect", trial("a", 1.2)), Verdict("form incomplete", trial("b", 1.0))], 1.0,
         "effect"),
        ([Verdict("effect", trial("a", 1.2)),
          Verdict("form incomplete", trial("b", 1.0), (), ("y",)), Verdict("nothing missing")],
         1.0, "effect"),
        ([Verdict("effect", trial("a", 1.2)),
          Verdict("cannot be told apart", trial("b", 1.0), (trial("c", 1.0),))], 1.0,
         "cannot be told apart"),
        ([Verdict("cannot be told apart", trial("a", 1.2), (trial("b", 1.0),)),
          Verdict("effect", trial("b", 1.0))], 1.0, "effect"),
        ([Verdict("effect", trial("a", 1.2)),
          Verdict("effect", trial("b", 1.0), (), (), ("friction:run",))], 1.0,
         "cannot be told apart"),
    ],
)  # fmt: skip
def test_doubts_of_every_round_reach_the_verdict(rounds, ratio, kind):
    assert conclude(rounds, 0.99, ratio).kind == kind


@pytest.mark.parametrize(("ratio", "kind"), [(1.43, "form incomplete"), (1.1, "effect")])
def test_a_form_that_leaves_more_than_any_right_one_stays_incomplete_at_a_floor_known_roughly(
    ratio, kind
):
    rounds = [Verdict("form incomplete", trial("a", ratio)), Verdict("nothing missing")]
    assert conclude(rounds, 0.7, ratio, limit=SINGLE).kind == kind


def test_patches_that_leave_much_do_not_close_an_open_round():
    later = trial("b", 1.25, coordinates=("y",))
    patches = [Verdict("open", trial("a", 1.3)), Verdict("effect", later)]
    assert conclude(patches, 0.6, 1.25).kind == "unknown"
    assert conclude(patches, 0.8, 1.15).kind == "form incomplete"


def test_effects_that_are_all_open_name_nothing_however_much_they_explain():
    patches = [Verdict("open", trial(name, 1.3), (), ("f:heat",)) for name in "abc"]
    said = conclude(patches, 0.95, 1.05, ["f:time"])
    assert (said.kind, said.coordinates) == ("unknown", ("f:time",))
    closed = [*patches, Verdict("form incomplete", trial("d", 1.1))]
    assert conclude(closed, 0.95, 1.25).kind == "form incomplete"


@pytest.mark.parametrize(
    ("share", "ratio", "kind"),
    [
        (0.89, 1.03, "unknown"), (0.91, 1.03, "effect"),
        (0.94, 1.07, "unknown"), (0.96, 1.07, "form incomplete"),
    ],
)  # fmt: skip
def test_a_form_and_a_patch_that_leave_much_name_nothing(share, ratio, kind):
    form = Verdict("form incomplete", trial("a", 1.3), (), ("f:x",))
    patch = Verdict("open", trial("b", 1.2), (), ("f:y",))
    left = Verdict("unknown", None, (), ("f:y",))
    said = conclude([form, patch, left], share, ratio, ["f:x"])
    assert (said.kind, said.coordinates[0]) == (kind, "f:x" if kind == "unknown" else "f:y")


@pytest.mark.parametrize(
    ("second", "share", "ratio", "kind"),
    [
        (("f:x",), 0.79, 1.07, "unknown"),
        (("f:x", "f:y"), 0.79, 1.07, "unknown"),
        (("f:y",), 0.79, 1.07, "form incomplete"),
        (("f:x",), 0.81, 1.07, "form incomplete"),
        (("f:x",), 0.79, 1.03, "effect"),
    ],
)
def test_two_effects_that_go_by_the_same_and_leave_much_are_patches(second, share, ratio, kind):
    rounds = [
        Verdict("form incomplete", trial("a", 1.2, coordinates=("f:x",))),
        Verdict("effect", trial("b", 1.1, coordinates=second)),
    ]
    assert conclude(rounds, share, ratio).kind == kind


@pytest.mark.parametrize(
    ("second", "ratio", "kind"),
    [(("f:x",), 1.6, "unknown"), (("f:y",), 1.6, "form incomplete"), (("f:x",), 1.1, "effect")],
)
def test_nor_do_two_that_go_by_the_same_if_a_further_round_sees_more_of_it(second, ratio, kind):
    rounds = [
        Verdict("form incomplete", trial("a", 1.2, coordinates=("f:x",))),
        Verdict("form incomplete", trial("b", 1.1, coordinates=second)),
        Verdict("unknown", None, (), ("f:x",)),
    ]
    assert conclude(rounds, 0.85, ratio, limit=SINGLE).kind == kind


@pytest.mark.parametrize(
    ("own", "left", "share", "kind"),
    [
        ("speed", (), 0.78, "form incomplete"),
        ("speed", (), 0.69, "unknown"),
        ("speed", ("breakaway:rest",), 0.79, "form incomplete"),
        ("speed", ("friction:y",), 0.88, "unknown"),
        ("speed", SPREAD, 0.88, "unknown"),
        ("displacement_since_reversal", SPREAD, 0.79, "form incomplete"),
    ],
)
def test_what_hardly_raises_the_error_or_is_an_effects_own_takes_no_name_back(
    own, left, share, kind
):
    first = Verdict("open", trial("a", 1.3), (), ("friction:y",))
    second = Verdict("form incomplete", trial("b", 1.15, coordinates=(f"friction:{own}",)))
    rounds = [first, second, Verdict("unknown", None, (), left)]
    assert conclude(rounds, share, 1.15).kind == kind


@pytest.mark.parametrize(
    ("own", "left", "share", "ratio", "limit", "kind"),
    [
        ("excitation", "friction:excitation", 0.94, 1.07, REPEATED, "unknown"),
        ("excitation", "friction:excitation", 0.96, 1.07, REPEATED, "form incomplete"),
        ("excitation", "friction:excitation", 0.94, 1.04, REPEATED, "form incomplete"),
        ("excitation", "vibration:excitation", 0.94, 1.07, REPEATED, "form incomplete"),
        ("displacement_since_reversal", "friction:speed", 0.71, 1.07, REPEATED, "form incomplete"),
        ("displacement_since_reversal", "friction:speed", 0.69, 1.07, REPEATED, "unknown"),
        ("excitation", "friction:excitation", 0.94, 2.0, SINGLE, "form incomplete"),
        ("excitation", "friction:excitation", 0.94, 4.0, SINGLE, "unknown"),
    ],
)
def test_a_law_that_leaves_a_force_above_what_a_right_form_leaves_is_another_one(
    own, left, share, ratio, limit, kind
):
    found = trial("a", ratio, coordinates=(f"friction:{own}",))
    rounds = [Verdict("form incomplete", found, (), (left,))]
    assert conclude(rounds, share, ratio, ["friction:torque"], limit).kind == kind


def test_a_set_of_effects_that_cannot_be_told_apart_stays_one_whatever_it_leaves():
    first = Verdict("cannot be told apart", trial("a", 1.2), (trial("b", 1.2),), ("friction:x",))
    assert conclude([first], 0.9, 1.2).kind == "cannot be told apart"


def test_a_rival_that_a_later_round_has_named_is_none_any_more():
    rounds = [
        Verdict("cannot be told apart", trial("a", 1.2), (trial("b", 1.2),)),
        Verdict("form incomplete", trial("b", 1.1), (), ("friction:x",)),
    ]
    assert conclude(rounds, 0.9, 1.1).kind == "unknown"
