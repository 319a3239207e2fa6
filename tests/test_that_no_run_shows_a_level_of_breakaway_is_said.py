"""Ramps that end before a clutch slips tell of its breakaway only that it is higher."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.fitting.replay import Breakaway
from simpter_hybrid.identification.reporting.shown_sizes import no_level_sentence


def said(coordinate, breakaways=()):
    effect = Some(name="dwell-breakaway", coordinates=(coordinate,))
    stuck, slips = Some(breakaways=()), Some(breakaways=breakaways)
    split = Some(fit=(stuck,), select=(stuck,), report=(slips,))
    search = Some(corrected=Some(effects=(effect,)))
    return no_level_sentence(Some(search=search, split=split, fitted=(stuck,)))


def test_a_ramp_that_goes_on_until_it_slips_is_asked_for():
    told = said("breakaway:rest")
    assert told.startswith("No run shows the level of a breakaway, which dwell-breakaway would")
    assert "until it slips" in told


@pytest.mark.parametrize(
    ("coordinate", "breakaways"),
    [("breakaway:rest", (Breakaway(3, 9.0, 0.1),)), ("friction:speed", ())],
)
def test_nothing_is_said_where_one_slipped_or_of_another_effect(coordinate, breakaways):
    assert said(coordinate, breakaways) == ""
