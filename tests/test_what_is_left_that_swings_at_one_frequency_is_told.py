"""An elastic part swings at its own frequency, a wave along the way at one for every speed."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.swinging import swinging_sentence
from simpter_hybrid.identification.tracing.swings import Line, lines_of, of_the_motion, same_line

TIME = 0.005 * np.arange(2000)
#: A motion of many speeds, and noise of a deviation of one.
PLACE = 6.0 * np.sin(0.9 * TIME)
SPEED = 5.4 * np.cos(0.9 * TIME)
RANDOM = np.random.default_rng(4)


def run(name, left):
    seen = Observation(left, 1.0, np.ones(TIME.size, bool))
    return Replay(name, name, TIME, {}, {"speed": seen}, notes={"speed": SPEED})


def noise():
    return RANDOM.standard_normal(TIME.size)


def still(replays):
    return {"speed": [0.0 * TIME for _ in replays]}


def lines(*courses):
    runs = [run(f"run {k + 1}", left) for k, left in enumerate(courses)]
    return lines_of(runs, still(runs))


@pytest.mark.parametrize("frequency", [4.0, 5.0, 7.0, 10.0, 29.0, 80.0])
def test_a_swing_stands_out_with_its_frequency_and_its_part(frequency):
    found = lines(noise() + 1.0 * np.sin(2 * np.pi * frequency * TIME))["run 1"]
    assert found.frequency == pytest.approx(frequency, abs=0.01)  # a bin's
    # Half a square beside one; noise of ten stretches makes a third of a bin's of it.
    assert found.part == pytest.approx(1.0 / 3.0, abs=0.05)


@pytest.mark.parametrize("frequency", [1.7, 2.0, 2.6, 3.0])
def test_what_is_slower_than_some_swings_in_a_stretch_is_no_line(frequency):
    assert lines(noise() + 3.0 * np.sin(2 * np.pi * frequency * TIME)) == {}


@pytest.mark.parametrize(
    ("frequency", "speed", "its"),
    [
        (29.0, SPEED, False),
        (6.0, np.sin(2 * np.pi * 2.0 * TIME), True),  # as dry friction's third harmonic
        (8.0, 3.0 + 0.1 * np.sin(TIME), True),  # as a wave along the way
        (7.0, np.sin(2 * np.pi * 2.0 * TIME), False),
        (7.0, 0.0 * TIME, True),
    ],
    ids=["slow motion", "a multiple", "one speed", "no multiple", "rest"],
)
def test_what_a_motion_does_itself_is_its_own(frequency, speed, its):
    assert of_the_motion(frequency, speed, 0.005) is its


@pytest.mark.parametrize(
    "left",
    [noise(), np.cumsum(noise()), noise() + np.sin(12.0 * PLACE), np.zeros(TIME.size)],
    ids=["noise", "slow noise", "a wave along the way", "nothing"],
)
def test_nothing_else_does(left):
    assert lines(left) == {}


def test_a_run_that_is_too_short_or_too_slow_has_no_line():
    short = Replay("a", "a", TIME[:300], {}, {"speed": Observation(
        np.sin(180.0 * TIME[:300]), 1.0, np.ones(300, bool))})  # fmt: skip
    slow = Replay("b", "b", 0.2 * np.arange(300), {}, short.observed)
    assert lines_of([short, slow], {"speed": [np.zeros(300)] * 2}) == {}


def test_runs_have_the_same_line_up_to_a_twentieth():
    at = {"a": 10.0, "b": 10.4, "c": 11.2, "d": 10.2}
    assert same_line({k: Line(f, 0.5, 20.0) for k, f in at.items()}) == ("a", "b", "d")
    assert same_line({"a": Line(10.0, 0.5, 20.0), "c": Line(11.0, 0.5, 20.0)}) == ()


def told(kind, where=()):
    swings = [run(f"run {k}", noise() + np.sin(2 * np.pi * 8.0 * TIME)) for k in (1, 2)]
    calm = run("run 3", noise())
    predictor = SimpleNamespace(predict=lambda values, replays: still(replays))
    model = SimpleNamespace(predictor=predictor, values={})
    done = SimpleNamespace(verdict=SimpleNamespace(kind=kind, coordinates=where), corrected=model)
    found = SimpleNamespace(
        search=done, split=SimpleNamespace(fit=swings[:1], select=[calm], report=swings[1:])
    )
    return swinging_sentence(found, SimpleNamespace(replays=swings[1:], after=still(swings[1:])))


def test_what_swings_in_two_runs_is_told_with_them():
    said = told("unknown")
    assert said.startswith("In run 1, run 2 what is left swings at 8 Hz")
    assert "sliding friction would hardly do that" in said


def test_where_it_rings_after_breakaways_it_may_be_what_gives_way():
    said = told("unknown", ("ringing:breakaway",))
    assert "bristles that ring" in said
    assert "hardly" not in said


def test_of_runs_at_rest_it_is_not(monkeypatch):
    monkeypatch.setattr("test_what_is_left_that_swings_at_one_frequency_is_told.SPEED", 0.0 * TIME)
    assert told("unknown") == ""


def test_beside_a_verdict_that_leaves_nothing_it_is_not():
    assert told("effect") == ""
