"""A drive in amperes or volts is no force: its motor makes one, and curves are sized by that."""

import numpy as np
import pytest
from axis_recordings import MODEL, recorded_axis

from simpter_hybrid.effects.position_friction import PositionFriction
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.drive_force import force_by
from simpter_hybrid.identification.axis.joints_rig import JointsTracer
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.empirical_terms import terms_over
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.tracing.signature import dependences
from simpter_hybrid.loads.drive import CurrentDrive, ForceDrive, VoltageDrive

#: Torque for each unit of the drive.
CONSTANT = 8.0
TOLD = np.array([0.0, 1.7, -3.3, 12.0])
SPEED = np.array([2.0, -1.0, 0.0, 5.0])
ON = np.zeros(4)


def traces_of(folder, constant):
    """Residual forces of a declared axis whose motor has this constant."""
    folder.mkdir()
    recording = recorded_axis(folder, [PositionFriction(clutch=0, once_sin=0.6)], 0.0,
                              lambda torque: torque / constant)  # fmt: skip
    declared = parse(MODEL.replace("1 N*m/V", f"{constant} N*m/V"))
    bench = bench_of(recording, declared, groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    return [
        bench.tracer(bench.parts[part])(bench.predictor, values, bench.parts[part])
        for part in ("fit", "select")
    ]


def test_curves_and_dependences_are_the_same_whatever_the_drive_is_told_in(tmp_path):
    made = [traces_of(tmp_path / name, c) for name, c in (("one", 1.0), ("other", CONSTANT))]
    sizes, found = [], []
    for learned, tested in made:
        sizes.append([terms_over("force:position", learned)[1].parameters[0].tolerance,
                      terms_over("force:heat", learned)[0].effect.high])  # fmt: skip
        depends = dependences(learned["force"], tested["force"])
        found.append([(d.coordinate, d.gain) for d in depends])
    # The drive is written with six decimals: 1e-6 of some 0.5 over the constant.
    assert sizes[1] == pytest.approx(sizes[0], rel=1e-4)
    names, gains = zip(*found[0], strict=True)
    others = dict(found[1])
    assert found[1][0][0] == names[0]
    assert [others[name] for name in names] == pytest.approx(gains, abs=1e-3)


def test_a_unit_constant_changes_no_digit():
    drive = np.random.default_rng(1).standard_normal(100)
    same = force_by((ForceDrive(1.0),), drive, 0.0 * drive, 0.0 * drive)
    np.testing.assert_array_equal(same, drive)


def test_each_motor_acts_by_its_own_law():
    by_current = force_by((CurrentDrive(2.5, coordinate=1.0),), TOLD, ON, SPEED)
    by_voltage = force_by((VoltageDrive(0.5, 2.0),), TOLD, ON, SPEED)
    # Closed forms; rounding.
    np.testing.assert_allclose(by_current, 2.5 * TOLD, rtol=1e-15)
    np.testing.assert_allclose(by_voltage, 0.5 * (TOLD - 0.5 * SPEED) / 2.0, rtol=1e-14)


def test_a_driver_that_coasts_brakes_during_its_pulses_alone():
    motor = VoltageDrive(0.5, 2.0, coasting=1.0, supply=12.0)
    pulses = np.abs(TOLD) / 12.0
    expected = 0.5 * (TOLD - pulses * 0.5 * SPEED) / 2.0
    np.testing.assert_allclose(force_by((motor,), TOLD, ON, SPEED), expected, rtol=1e-14)


def test_a_motor_with_open_ends_gives_none():
    assert not force_by((ForceDrive(3.0),), TOLD, ON + 1.0, SPEED).any()


def test_each_joint_has_the_torque_of_its_own_motor():
    motors = ((ForceDrive(2.0),), (ForceDrive(5.0, coordinate=1.0),))
    tracer = JointsTracer((1.0, 1.0), (np.inf, np.inf), motors)
    inputs = {"torque_1": TOLD, "torque_2": 2.0 * TOLD}
    run = Replay("", "", np.arange(4.0), inputs, {}, notes={"speed_1": SPEED, "speed_2": SPEED})
    np.testing.assert_array_equal(tracer.drive(run, 0), 2.0 * TOLD)
    np.testing.assert_array_equal(tracer.drive(run, 1), 10.0 * TOLD)
