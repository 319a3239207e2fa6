"""What runs held out leave is held against runs of their kind, if some fit or select."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.reporting.not_shown import uneven_sentence


def said(fit, select, held_out=138.0, floor=1.0):
    """Of a kind whose runs leave so much, where those that select leave 31.4 together."""
    model = Some(select_error=31.4, effects=())
    search = Some(corrected=model, floor=1.0, verdict=Some(kind="unknown"))
    parts = {"fit": fit, "select": select}
    runs = {k: [{"experiment": "minimum jerk", "after": e} for e in v] for k, v in parts.items()}
    errors = {"minimum jerk": {"after": held_out, "floor": floor}}
    return uneven_sentence(Some(search=search, levels=()), errors, runs)


def test_those_that_are_about_as_far_off_as_these_are_not_told():
    assert said([71.8], [60.3]) == ""
    assert said([71.8], []) == ""


@pytest.mark.parametrize(
    ("floor", "words"),
    [(1.0, "138 times the floor, against 31"), (2.0, "69 times the floor, against 15.5")],
)
def test_of_those_that_are_far_worse_it_is_not_asked_that_their_kind_fits(floor, words):
    told = said([2.0], [31.0, 31.0], floor=floor)
    assert f"far worse than those of their kind that fit or select (minimum jerk {words})" in told
    assert "let some of their kind" not in told


def test_a_kind_that_neither_fits_nor_selects_is_held_against_all_that_select():
    told = said([], [])
    assert "far worse than those that select (minimum jerk 138 times the floor, against" in told
    assert told.endswith("let some of their kind fit and select as well.")
