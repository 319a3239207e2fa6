"""What is let alone slows from its first row on: a speed that is held is still driven."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.driven_on import driven_on, held_rows
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun

TIME = 0.05 * np.arange(60)
NOISE = 0.05
#: Speeds from where they were let go.
FREE = {
    "drag": 20.0 * np.exp(-TIME),
    "dry friction": 20.0 - 6.0 * TIME,
    "pendulum from its lowest place": 3.0 * np.cos(2.0 * TIME),
    "friction that rises as it slows": 20.0 - 2.0 * TIME**2,
}


def noisy(speed):
    return speed + NOISE * np.random.default_rng(3).standard_normal(speed.size)


@pytest.mark.parametrize("name", FREE)
def test_what_slows_from_the_first_row_on_is_not(name):
    assert held_rows(TIME, noisy(FREE[name]), NOISE) == 0


@pytest.mark.parametrize("rows", [4, 10])
def test_a_speed_that_is_held_is(rows):
    held = np.concatenate([np.full(rows, 20.0), FREE["drag"]])
    time = 0.05 * np.arange(held.size)
    # The row of the release belongs to both.
    assert held_rows(time, noisy(held), NOISE) == pytest.approx(rows, abs=1)


def test_backwards_as_well():
    held = -np.concatenate([np.full(10, 20.0), FREE["drag"]])
    assert held_rows(0.05 * np.arange(held.size), noisy(held), NOISE) == pytest.approx(10, abs=1)


def test_a_speed_that_is_held_to_the_end_is_not():
    assert held_rows(TIME, noisy(np.full(60, 20.0)), NOISE) == 0


@pytest.mark.parametrize("phase", np.arange(0.0, 6.2, 0.3))
def test_what_swings_holds_no_speed(phase):
    time = 0.02 * np.arange(400)
    swings = 3.0 * np.cos(3.0 * time + phase) * np.exp(-0.05 * time)
    assert held_rows(time, noisy(swings), NOISE) == 0


@pytest.mark.parametrize("noise", [0.0, 0.05])
def test_what_coasts_to_rest_and_stays_there_is_not(noise):
    # A tachometer in steps: exact zeros at the end, and exact repetitions before.
    steps = np.maximum(0.0, np.round(20.0 * (2.0 - TIME)) / 20.0)
    assert held_rows(TIME, steps, noise) == 0
    assert held_rows(TIME, 0.0 * TIME, noise) == 0


@pytest.mark.parametrize(("piece", "count"), [(0, 1), (1, 1), (2, 0)])
def test_a_later_piece_of_a_run_was_let_go_already(piece, count):
    held = noisy(np.concatenate([np.full(10, 20.0), FREE["drag"]]))
    time = 0.05 * np.arange(held.size)
    channel = ChannelMap("speed", "v", "m/s", "measured", noise=NOISE)
    run = RecordedRun("one", "", "", (0, held.size), time, {"speed": held}, piece=piece)
    assert len(driven_on([run], channel, "speed")) == count
