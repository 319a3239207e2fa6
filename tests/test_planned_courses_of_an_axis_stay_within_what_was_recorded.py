"""Courses that are recommended go no farther than recorded runs went; they are really driven."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.experiments import AxisReach, axis_experiments, strokes
from simpter_hybrid.identification.axis.motor import motor_of
from simpter_hybrid.identification.axis.plan import BEYOND, axis_reach, planned_axis
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


def planned_with(tmp_path, weight, **known):
    """What is laid down where the axis hardly rubs and has a weight [N m], and some other reach."""
    recording, signals = recorded_axis(tmp_path, (), 0.01), AxisSignals()
    declared = declared_axis()
    (clutch,) = declared.clutches
    slides = replace(clutch, torque=replace(clutch.torque, coulomb=0.01, viscous=0.0))
    device = replace(declared.device, weight=weight)
    declared = replace(declared, device=device, clutches=(slides,))
    reach = axis_reach(axis_replays(recording, signals), 0.02, motor_of(declared)[1])
    reach = replace(reach, duration=2.0, **known)
    planned, laid_down = planned_axis(recording, declared, reach, signals)
    assert [run.name for run in planned.runs] == list(laid_down)
    return reach, laid_down


@pytest.mark.parametrize("half", [0.5, 1.0])
def test_a_motion_keeps_to_the_way_also_where_the_drive_turns_it_late(tmp_path, half):
    # At 40 rad/s it takes 32 rad to stop, where strokes of twice `half` are asked for.
    reach, laid_down = planned_with(tmp_path, 0.0, force=0.5, low=-half, high=half, speed=40.0)
    assert list(laid_down) == list(axis_experiments(reach))
    more = BEYOND * (reach.high - reach.low)
    for laid in laid_down.values():
        assert np.abs(laid["torque"]).max() <= reach.force * (1.0 + 1e-9)
        assert reach.low - more <= laid["position"].min()
        assert laid["position"].max() <= reach.high + more


@pytest.mark.slow
def test_what_carries_the_axis_off_however_slowly_it_is_driven_is_not_asked_for(tmp_path):
    # From 1.9 rad it swings to the other side, and the drive holds next to nothing of its weight.
    assert planned_with(tmp_path, 5.0, force=1e-3, low=1.5, high=2.3)[1] == {}
