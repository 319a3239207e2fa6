"""Cogging is found with weight off the axis beside it: of that each interval may hold zero."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.effects.imbalance import Imbalance
from simpter_hybrid.effects.position_friction import PositionFriction
from simpter_hybrid.effects.ripple_force import RippleForce
from simpter_hybrid.identification.reporting.parts_shown import parts_sentence
from simpter_hybrid.identification.rigs.candidate import candidate

FIELDS = ("1.cosine", "1.sine", "2.cosine", "2.sine")
COGGING = candidate(
    "imbalance-ripple-3", Imbalance(coordinate=0), tuple((f, -1.0, 1.0, 0.1) for f in FIELDS),
    ((0.0, 0.0, 0.0, 0.0),), ("position",), more=(RippleForce(number=3.0, coordinate=0),),
)  # fmt: skip
PLATE = candidate(
    "position-friction-5", PositionFriction(number=5.0, clutch=0),
    tuple((f, -0.5, 0.5, 0.1) for f in ("once_cos", "once_sin", "often_cos", "often_sin")),
    ((0.0, 0.0, 0.0, 0.0),), ("position",),
)  # fmt: skip
#: Of both parts: surely not zero, by one of its sizes; and zero within both intervals.
SURE, NONE = ((0.13, 1e-3), (0.0, 1e-3)), ((4e-4, 5e-4), (-4e-4, None))


def said(effect, *sizes):
    every = zip(effect.parameters, (size for part in sizes for size in part), strict=True)
    rows = [{"name": p.name, "value": value, "half_width": w} for p, (value, w) in every]
    found = SimpleNamespace(search=SimpleNamespace(corrected=SimpleNamespace(effects=(effect,))))
    return parts_sentence(found, rows)


@pytest.mark.parametrize(
    ("effect", "none"),
    [(COGGING, "of weight off the axis no 95 % interval"), (PLATE, "once a turn no 95 % interval")],
)
def test_the_part_whose_sizes_may_all_be_zero_is_named(effect, none):
    assert said(effect, NONE, SURE).startswith(f"Of {effect.name} these data show")
    assert none in said(effect, NONE, SURE)


def test_and_what_is_shown():
    assert "show the wave of friction once a turn, and no more" in said(PLATE, SURE, NONE)


def test_nothing_is_said_where_each_part_has_a_size():
    assert said(COGGING, SURE, SURE) == ""


def test_parts_that_make_up_for_each_other_are_told_where_nothing_else_says_so():
    assert "no part is sure by itself (weight off the axis and" in said(COGGING, NONE, NONE)
    assert said(PLATE, NONE, NONE) == ""
