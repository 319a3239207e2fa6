"""A model that samples far more often than its record has rows takes no step for nothing."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.played import played_every
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rigs.scenario_runner import GivenRun

FINE, ROW = 1e-4, 2e-3
TIME = ROW * np.arange(500)


def test_what_never_changes_is_a_step_a_row_and_none_is_long():
    assert played_every(TIME, FINE, changes=False, held=False) == pytest.approx(ROW)
    assert played_every(20.0 * TIME, FINE, changes=False, held=False) == pytest.approx(0.01)


def test_what_is_held_is_a_step_a_row():
    assert played_every(TIME, FINE, changes=True, held=True) == pytest.approx(ROW)


def test_what_goes_on_is_two_steps_a_row_and_none_is_long():
    assert played_every(TIME, FINE, changes=True, held=False) == pytest.approx(0.5 * ROW)
    assert played_every(10.0 * TIME, FINE, changes=True, held=False) == pytest.approx(2.5e-3)


@pytest.mark.parametrize("held", [False, True])
def test_it_is_never_finer_than_the_model_samples(held):
    assert played_every(TIME, 0.75 * ROW, changes=True, held=held) >= 0.75 * ROW


def test_rows_that_are_not_even_are_played_as_finely_as_the_model_samples():
    assert played_every(np.delete(TIME, 7), FINE, changes=True, held=True) == FINE


@pytest.mark.parametrize("held", ["after", "before", "sampled"])
def test_the_motion_is_that_of_a_fine_play(held, tmp_path):
    recording = recorded_axis(tmp_path, [])
    channels = dict(recording.channels)
    channels["torque"] = replace(channels["torque"], held=held)
    recording = replace(recording, map=replace(recording.map, channels=channels))
    signals = AxisSignals()
    replay = axis_replays(recording, signals)[0]
    fine = replace(declared_axis(), period=FINE)
    predictor = ScenarioPredictor(fine, AxisRig())
    values = {p.name: p.value for p in predictor.parameters}
    played = predictor.predict(values, [replay])[signals.position][0]
    data = AxisRig().pack(replay, FINE)
    p, switching = predictor.vector(values)
    start, restarts = AxisRig().start(replay), AxisRig().restarts(replay)
    rows, _ = predictor.runner.run(GivenRun(p, switching, data, replay.time, restarts, start, FINE))
    # Held, both are the same input; else steps of 2 ms follow the torque's course to a part in
    # ten thousand of the way.
    rel = 1e-5 if held != "sampled" else 1e-4
    assert played == pytest.approx(rows[:, 0], abs=rel * np.ptp(rows[:, 0]))
