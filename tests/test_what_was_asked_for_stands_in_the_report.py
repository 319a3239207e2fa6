"""Effects that were not tried, and how far to go: a verdict is to be read with them."""

from pathlib import Path

from simpter_hybrid.effects.stribeck import Stribeck
from simpter_hybrid.identification.reporting.page import TOLD
from simpter_hybrid.identification.reporting.request import Request

BARE = Request(("d.csv",), Path("m.toml"), Path("map.toml"), None, None)


def test_names_that_were_left_out_are_said_below_the_verdict():
    asked = Request(*_files(), without=("stribeck", "drift"))
    assert "stribeck, drift" in asked.left_out
    assert "left_out" in TOLD
    assert BARE.left_out == ""


def test_options_and_effects_of_ones_own_are_told_by_their_names():
    asked = Request(*_files(), also=(Stribeck,), without=("drift",), effort=0.5).asked
    assert asked["without"] == ["drift"]
    assert asked["also"] == ["simpter_hybrid.effects.stribeck:Stribeck"]
    assert asked["effort"] == 0.5
    assert BARE.asked["effort"] == 1.0


def _files():
    return BARE.files, BARE.model, BARE.map, None, None
