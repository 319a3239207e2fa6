"""Courses that are recommended go no farther than recorded runs went; they are really driven."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.experiments import AxisReach, axis_experiments, strokes
from simpter_hybrid.identification.axis.motor import motor_of
from simpter_hybrid.identification.axis.plan import axis_reach, planned_axis
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals

REACH = AxisReach(-0.1, 0.3, 0.5, 10.0, 2.0, 8.0, 2e-3)


@pytest.mark.parametrize("name", axis_experiments(REACH))
def test_a_course_stays_within_way_and_speed(name):
    course = axis_experiments(REACH)[name]
    assert course.size == REACH.time.size
    assert REACH.low <= course.min() < course.max() <= REACH.high
    fast = np.abs(np.diff(course)) / REACH.step
    # What steps is a jump that a servo with a limit follows.
    steps = name == "steps to and fro"
    assert np.quantile(fast, 0.98 if steps else 1.0) <= (1.0 + 1e-9) * REACH.speed


def test_a_stroke_has_one_speed_and_turns_at_its_ends():
    course = strokes(REACH.time, 0.2, 0.1)
    assert np.abs(np.diff(course)).max() == pytest.approx(0.2 * REACH.step)
    assert (course.min(), course.max()) == pytest.approx((-0.1, 0.1), abs=0.2 * REACH.step)


def test_planned_runs_are_driven_within_the_force_and_replayed_like_recorded_ones(tmp_path):
    recording, signals = recorded_axis(tmp_path, (), 0.01), AxisSignals()
    declared = declared_axis()
    reach = axis_reach(axis_replays(recording, signals), 0.02, motor_of(declared)[1])
    reach = replace(reach, duration=2.0)
    planned, laid_down = planned_axis(recording, declared, reach, signals)
    assert list(laid_down) == list(axis_experiments(reach))
    assert [run.name for run in planned.runs] == list(axis_experiments(reach))
    for run in planned.runs:
        assert set(run.channels) == {"position", "speed", "torque"}
        # The estimated noise of the torque comes on top of what the servo asks.
        assert np.abs(run.channels["torque"]).max() <= 1.02 * reach.force
    replays = axis_replays(planned, signals)
    assert all(set(r.observed) == {"speed"} for r in replays)
