"""A rotor's run that begins late, in motion or loaded, or with a gap, is replayed as recorded."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.recording import RecordedRun
from simpter_hybrid.identification.rotor.beginnings import (
    beginning,
    beginning_remarks,
    inputs_by_time,
)
from simpter_hybrid.identification.rotor.signals import RotorSignals

STEP, SETTLES = 0.002, 0.1
TIME = STEP * np.arange(1, 1001)
SD = {"clutch_torque": 0.2, "motor_torque": 0.3, "speed": 0.01, "position": 1e-4}
KICK = np.where(np.arange(TIME.size) < 1, 40.0, 0.0)


def run_of(speed=0.0, carried=0.0, applied=None, stamps=TIME, torque=np.nan):
    """A run at one speed from 0, as long as its stamps."""
    every = np.ones(stamps.size)
    channels = {
        "clutch_torque": carried * every,
        "motor_torque": carried * every if applied is None else applied,
        "speed": speed * every,
        "position": speed * (stamps - stamps[0]),
        "command": every,
        "reference_torque": torque * every,
        "reference_speed": speed * every,
    }
    return RecordedRun("run", "run", "", (0, stamps.size), stamps, channels)


def begun(run):
    return beginning(run, RotorSignals(), SD, SETTLES)


@pytest.mark.parametrize("run", [run_of(), run_of(speed=1.0, applied=KICK)], ids=["rest", "kick"])
def test_a_run_from_rest_is_taken_as_it_is(run):
    found = begun(run)
    # But for the last digits of its stamps, by which a row would hold what the next one does.
    assert np.array_equal(found.time, np.round(run.time, 9))
    assert found.start is None
    assert found.keep.all()
    assert beginning_remarks(SimpleNamespace(runs=[run]), RotorSignals(), SD, SETTLES) == ()


@pytest.mark.parametrize(
    ("away", "under_way"), [(0.0, False), (0.1, True)], ids=["where it was", "elsewhere"]
)
def test_a_rotor_that_a_torque_speeds_up_between_rows_far_apart_began_at_rest(away, under_way):
    stamps = 0.005 * np.arange(1, 401)
    run = run_of(stamps=stamps, torque=0.5)
    speed = 0.55 * (1.0 - np.exp(-stamps / 0.018))  # 0.13 rad/s in the first row, 0.23 in the next
    angle = away + 0.55 * (stamps - 0.018 * (1.0 - np.exp(-stamps / 0.018)))
    run = replace(run, channels={**run.channels, "speed": speed, "position": angle})
    assert begun(run).under_way is under_way


def pushed(late, at=0.0, rests=0):
    """A rotor at 500 rad/s^2 from rest, of which so many rows of 1 ms were not recorded."""
    stamps = 0.001 * np.arange(1, 401)
    moving = 0.001 * np.maximum(np.arange(1, 401) + late - rests, 0)
    run = run_of(stamps=stamps, torque=0.5)
    angle = 250.0 * moving**2
    seen = {"speed": 500.0 * moving, "position": at + angle - angle[0]}
    return replace(run, channels={**run.channels, **seen})


@pytest.mark.parametrize(("late", "under_way"), [(0, False), (1, True), (2, True), (6, True)])
def test_a_run_of_which_rows_are_missing_is_under_way(late, under_way):
    assert begun(pushed(late)).under_way is under_way


def test_a_rotor_that_rests_elsewhere_and_is_pushed_begins_there_at_rest():
    found = begun(pushed(0, at=1.0, rests=3))
    assert not found.under_way
    assert (found.start.position, found.start.speed) == (1.0, 0.0)


def test_a_rotor_that_is_thrown_off_at_once_begins_where_it_was():
    speed = np.minimum(750.0 * TIME, 3.0)  # 1.5 rad/s in the first row
    angle = np.concatenate([[0.5 * speed[0] * STEP], 0.5 * speed[0] * STEP + np.cumsum(
        0.5 * (speed[1:] + speed[:-1])) * STEP])  # fmt: skip
    run = run_of(applied=KICK)
    run = replace(run, channels={**run.channels, "speed": speed, "position": angle})
    assert begun(run).start is None
    away = replace(run, channels={**run.channels, "position": angle + 0.1})
    assert begun(away).start is not None


def test_stamps_count_from_the_start_of_a_run():
    assert np.array_equal(begun(run_of(stamps=np.round(TIME + 5.0, 3))).time, np.round(TIME, 3))


@pytest.mark.parametrize("rows", [-1.0, -0.4, 0.4])
def test_the_first_inputs_of_a_run_from_rest_hold_for_one_row_wherever_its_stamps_begin(rows):
    run = run_of(stamps=np.round(TIME + rows * STEP, 9))
    assert np.array_equal(begun(run).time, np.round(TIME, 9))
    assert beginning_remarks(SimpleNamespace(runs=[run]), RotorSignals(), SD, SETTLES) == ()


@pytest.mark.parametrize(
    "run",
    [run_of(speed=1.0, carried=9.0), run_of(speed=1.0), run_of(speed=-1.0, torque=0.0)],
    ids=["loaded", "settled servo", "coasting"],
)
def test_a_run_under_way_is_set_from_its_first_samples_and_left_to_settle(run):
    found = begun(run)
    assert found.start.speed == pytest.approx(run.channels["speed"][0])
    assert found.time[0] > SETTLES  # its first inputs are held before
    assert not found.keep[:50].any()
    assert found.keep[50:].all()
    (said,) = beginning_remarks(SimpleNamespace(runs=[run]), RotorSignals(), SD, SETTLES)
    assert "under way" in said.what


def test_inputs_keep_their_time_over_a_gap_behind_which_nothing_is_compared_at_once():
    stamps = np.concatenate([TIME[:400], TIME[600:]])
    chosen, before = inputs_by_time(stamps, STEP)
    assert before == 0
    assert chosen.size == TIME.size
    assert stamps[chosen[700]] == TIME[700]
    assert (chosen[400:601] == 400).all()
    keep = begun(run_of(stamps=stamps)).keep
    assert np.flatnonzero(~keep).tolist() == list(range(400, 450))
