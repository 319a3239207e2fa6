"""What begins where only selecting runs go no fit can size: a reader is told how far they went."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.reporting.beyond_fitted import beyond_fitted_sentence

TIME = 4 * np.pi * np.arange(1001) / 1001
CHANNELS = {
    "position": ChannelMap("position", "x", "mm", "measured", scale=1e-3, sign=-1),
    "speed": ChannelMap("speed", "v", "m/s", "measured"),
}


def run(reach, rate=1.0):
    notes = {"position": reach * np.sin(rate * TIME), "speed": reach * rate * np.cos(rate * TIME)}
    return Replay("run", "run", TIME, {}, {}, notes=notes)


def said(fitted, selecting, kind="unknown", channels=CHANNELS):
    found = Some(
        search=Some(verdict=Some(kind=kind)), fitted=[fitted], split=Some(select=[selecting])
    )
    return beyond_fitted_sentence(found, Some(channels=channels))


def test_places_and_speeds_are_told_in_the_units_of_the_record():
    told = said(run(0.065), run(0.183))
    assert "position -183 to 183 mm, against -65 to 65 mm" in told
    assert "speed up to 0.183 m/s, against up to 0.065 m/s" in told
    fast = said(run(0.065), run(0.065, 2.0))
    assert "position" not in fast
    assert "speed up to 0.13 m/s" in fast


def test_a_little_farther_is_no_matter():
    assert said(run(0.065), run(0.08)) == ""


@pytest.mark.parametrize("kind", ["effect", "nothing missing", "cannot be told apart"])
def test_where_nothing_is_left_nothing_is_said(kind):
    assert said(run(0.065), run(0.183), kind) == ""


def test_what_turns_comes_to_every_place():
    turns = {"position": ChannelMap("position", "x", "rad", "measured")}
    assert said(run(7.0), run(40.0), channels=turns) == ""


@pytest.mark.parametrize(("less", "told"), [(0.0, False), (2.0, True)])
def test_a_turn_begun_anew_in_each_run_is_one_place(less, told):
    wraps = {"position": ChannelMap("position", "x", "rad", "measured", wraps=2 * np.pi)}
    fitted, selecting = run(3.1 - less), run(3.1)
    course = selecting.notes["position"] - 2 * np.pi
    later = Replay("run", "run", TIME, {}, {}, notes={"position": course})
    assert ("position" in said(fitted, later, channels=wraps)) is told


def test_places_that_begin_at_zero_keep_their_offset():
    moved = ChannelMap("position", "x", "mm", "measured", scale=1e-3, shift=-5e-3)

    def upward(reach):
        notes = {"position": np.append(np.zeros(100), reach * np.abs(np.sin(TIME)))}
        return Replay("run", "run", TIME, {}, {}, notes=notes)

    told = said(upward(0.01), upward(0.04), channels={"position": moved})
    assert "position 5 to 45 mm, against 5 to 15 mm" in told
