"""A sensor of force that shows it late or too large, a driver that follows late: no friction."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis
from scipy.signal import lfilter

from simpter_hybrid.controllers.drive_delay import DriveDelay
from simpter_hybrid.identification.axis.drive import current_candidates, drive_candidates
from simpter_hybrid.identification.axis.force_sensor import sensed, shown
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.loads.drive import CurrentDrive, VoltageDrive
from simpter_hybrid.sensor import Sensor


def late(drive):
    return np.concatenate([np.zeros(3), drive[:-3]])  # 12 ms


@pytest.mark.slow
def test_a_late_sensor_is_named_with_its_delay(tmp_path):
    recording = recorded_axis(tmp_path, (), shown=late)
    done = diagnose(recording, declared_axis()).search
    (found,) = done.corrected.effects
    assert (found.name, found.acts_on) == ("force-delay", "sensor")
    # Three rows of 4 ms.
    assert done.corrected.values["force-delay.delay"] == pytest.approx(0.012, abs=2e-4)


@pytest.mark.slow
def test_a_driver_that_follows_late_is_named_with_its_lag(tmp_path):
    # What acts follows what is told: told is what acts, led by the lag's inverse.
    def told(acts, lag=0.02, step=0.004):
        kept = np.exp(-step / lag)
        return lfilter([1.0 / (1.0 - kept), -kept / (1.0 - kept)], [1.0], acts)

    recording = recorded_axis(tmp_path, (), shown=told, drive="told")
    done = diagnose(recording, declared_axis()).search
    (found,) = done.corrected.effects
    assert (found.name, found.acts_on) == ("drive-lag", "actuator")
    # The record is told smoothly, the servo's inverse in steps: half a row.
    assert done.corrected.values["drive-lag.lag"] == pytest.approx(0.02, abs=0.003)


@pytest.mark.slow
def test_a_driver_that_acts_after_a_dead_time_is_named_with_it_and_nothing_is_missing_then(
    tmp_path,
):
    def told(acts):
        return np.concatenate([acts[3:], np.repeat(acts[-1], 3)])  # 12 ms

    recording = recorded_axis(tmp_path, (), shown=told, drive="told")
    done = diagnose(recording, declared_axis()).search
    (found,) = done.corrected.effects
    assert (found.name, found.acts_on) == ("drive-delay", "actuator")
    late = done.corrected.values["drive-delay.delay"]
    assert late == pytest.approx(0.012, abs=2e-4)
    corrected = done.corrected.predictor.scenario(done.corrected.values)
    assert corrected.controllers[-1] == (DriveDelay(late), 1)
    assert diagnose(recording, corrected).search.verdict.kind == "nothing missing"


@pytest.mark.slow
def test_a_motor_that_saturates_is_named_with_how_much_less_it_gives(tmp_path):
    # The most that is told gives a fifth less than in proportion: acts = told / (1 + bent told^2).
    def told(acts):
        bent = 0.16 / np.max(np.abs(acts)) ** 2
        root = np.sqrt(1.0 - 4.0 * bent * acts**2)
        return 2.0 * acts / (1.0 + root)

    recording = recorded_axis(tmp_path, (), shown=told, drive="told")
    done = diagnose(recording, declared_axis()).search
    (found,) = done.corrected.effects
    assert (found.name, found.acts_on) == ("drive-saturation", "actuator")
    # Inertia and friction are known to some per cent: of a force they tell no more.
    assert done.corrected.values["drive-saturation.fall"] == pytest.approx(0.25, abs=0.05)


def test_a_current_that_a_sensor_saw_may_saturate_its_motor():
    by_current = replace(declared_axis(), loads=(CurrentDrive(0.5),))
    assert [c.name for c in current_candidates(by_current, 3.0)] == ["drive-saturation"]
    assert current_candidates(declared_axis(), 3.0) == ()  # a force that a sensor saw acts


def test_only_what_was_recorded_is_doubted():
    names = [[c.name for c in drive_candidates(declared_axis(), s)] for s in (True, False)]
    assert names == [
        ["force-gain", "force-delay", "force-lag"],
        ["drive-gain", "drive-deadband", "drive-limit", "drive-saturation", "drive-lag",
         "drive-delay"],
    ]  # fmt: skip


def test_what_acts_may_follow_late_what_a_sensor_is_said_to_have_seen(tmp_path):
    recording = as_recorded(recorded_axis(tmp_path, []))
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    timing = {c.name for c in bench.candidates if c.family == "drive timing"}
    assert timing == {"force-delay", "force-lag", "drive-lag"}


def test_of_a_voltage_another_motor_is_no_other_gain():
    motor = VoltageDrive(constant=0.4, resistance=4.0)
    declared = replace(declared_axis(), loads=(motor,))
    gives, other, warm, heats, dead, cut, _, follows, _ = drive_candidates(declared, False)
    assert (gives.effect.constant, follows.effect.constant) == (0.1, 0.1)
    assert dead.effect.constant == 0.1
    assert (heats.effect.constant, heats.effect.back) == (0.1, pytest.approx(0.04))
    assert (cut.effect.constant, cut.effect.back) == (0.1, pytest.approx(0.04))
    assert warm.shifts == (("motor-resistance.change", "load.1.resistance", 4.0),)
    assert other.shifts == (("motor-constant.change", "load.1.constant", 0.4),)


def test_a_motors_constant_that_is_known_to_a_tolerance_is_not_asked_again():
    declared = declared_axis()
    known = {"name": "constant", "parameters": ["load.1.constant"], "relative": 0.1}
    notes = {**declared.notes, "tolerances": (*declared.notes["tolerances"], known)}
    left = drive_candidates(replace(declared, notes=notes), False)
    assert [c.name for c in left] == [
        "drive-deadband", "drive-limit", "drive-saturation", "drive-lag", "drive-delay",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("errors", "values"),
    [
        ({"gain": 0.1, "offset": 0.3}, {"force-gain.gain": 0.1, "force-offset.offset": 0.3}),
        ({"delay": 0.01}, {"force-delay.delay": 0.01}),
        ({"filter": 0.01}, {"force-lag.lag": 0.01}),
    ],
)
def test_what_a_sensor_with_such_errors_shows_is_predicted_and_put_right_again(errors, values):
    time, period = 2e-3 * np.arange(1000), 2e-3

    def force(t):
        return 3.0 * np.sin(5.0 * t)

    read = Sensor(**errors).read(time, force)
    # Where a tester moves the axis, the force that a model predicts is shown by the same sensor.
    assert shown(time, force(time), values)[20:] == pytest.approx(read[20:], abs=2e-3)
    inputs = {"drive": read, "press": 0 * time, "released": 0 * time, "holds": 0 * time}
    right = sensed(Replay("run", "run", time, inputs, {}), values)
    ticks = AxisRig().pack(right, period)[3:].reshape(-1, 3)[20:-20, 2]
    middle = (np.arange(ticks.size) + 20.5) * period
    # The sensor's errors are added row by row, straight between: (5 * 0.002)^2 / 8 of 3 N at most.
    assert ticks == pytest.approx(force(middle), abs=2e-3)
