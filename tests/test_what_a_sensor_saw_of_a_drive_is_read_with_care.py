"""Rows, signs and units in which a sensor beside a drive says nothing of the driver, or less."""

from dataclasses import replace

import numpy as np
import pytest
from motor_by_voltage import MODEL, K, R

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.axis.seen_drive import BY_IT, NO_LAW, seen_drive
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.loads.drive import CurrentDrive, ForceDrive

TIME = 0.002 * np.arange(4000)
SPEED = 80.0 * np.sin(3.0 * TIME - 0.8)
VOLTS = 9.0 * np.sin(3.0 * TIME)
MOTOR = parse(MODEL, "m.toml")
AS_DECLARED = "it goes with a driver and a motor as declared"
CHANNELS = {
    "speed": ("rad/s", "measured"), "drive": ("V", "input"), "duty": ("1", "input"),
    "supply": ("V", "input"), "torque_on": ("1", "input"), "current": ("A", "measured"),
    "torque": ("N*m", "measured"),
}  # fmt: skip


def law(folder, model=MOTOR, amperes=False, noise=1e-3, **columns):
    """What is said of the channel that is measured; columns by the names of signals."""
    columns = {"s": TIME, "speed": SPEED, **columns}
    for name in ("current", "torque"):
        if name in columns:
            columns[name] = columns[name] + noise * np.random.default_rng(2).normal(size=TIME.size)
    text = '[time]\ncolumn = "s"\nunit = "s"\n'
    for name in columns.keys() - {"s"}:
        unit, role = CHANNELS[name]
        unit = "A" if amperes and name == "drive" else unit
        text += f'[channels.{name}]\ncolumn = "{name}"\nunit = "{unit}"\nsign = 1\n'
        text += f'role = "{role}"\n'
    (folder / "map.toml").write_text(text)
    rows, names = np.column_stack(list(columns.values())), ",".join(columns)
    np.savetxt(folder / "d.csv", rows, "%.7g", ",", header=names, comments="")
    recording = as_axis(load_recording([folder / "d.csv"], folder / "map.toml"))
    (remark,) = seen_drive(recording, model, AxisSignals())
    return remark.value


def drawn(volts, speed=SPEED):
    return (volts - K * speed) / R


def driven(load):
    return replace(MOTOR, loads=(load,))


def test_rows_beside_a_jump_do_not_count(tmp_path):
    stairs = np.repeat(np.random.default_rng(3).uniform(-9.0, 9.0, 200), 20)
    before = np.concatenate([stairs[:1], stairs[:-1]])  # read before the next was set
    assert law(tmp_path, drive=stairs, current=drawn(before)) == AS_DECLARED


def test_a_duty_counts_times_its_supply_and_released_rows_do_not(tmp_path):
    supply, on = 12.0 + np.sin(TIME), (np.arange(TIME.size) % 500 < 400).astype(float)
    columns = {"duty": VOLTS / supply, "supply": supply, "torque_on": on}
    assert law(tmp_path, **columns, current=on * drawn(VOLTS)) == AS_DECLARED


@pytest.mark.parametrize(
    ("load", "amperes", "signal"),
    [(ForceDrive(0.5), False, "torque"), (CurrentDrive(K), True, "current")],
)
def test_a_gain_is_told_of_a_force_and_of_a_current(tmp_path, load, amperes, signal):
    constant = 0.5 if signal == "torque" else 1.0
    for times, told in ((1.0, AS_DECLARED), (1.2, "the gain is 1.2 times the declared one")):
        seen = {signal: times * constant * VOLTS}
        assert told in law(tmp_path, driven(load), amperes, drive=VOLTS, **seen)


def test_what_falls_with_speed_beside_a_driver_of_force_is_told(tmp_path):
    seen = 0.5 * VOLTS - 0.01 * SPEED
    said = law(tmp_path, driven(ForceDrive(0.5)), drive=VOLTS, torque=seen)
    assert "falls by 0.8000" in said
    assert "at the largest speed, as of a motor that voltage drives" in said


@pytest.mark.parametrize(
    ("seen", "said"),
    [(-drawn(VOLTS), "sign in the map is wrong"), (np.abs(drawn(VOLTS)), "there is no sign"),
     (0.0 * VOLTS, "nothing of what is told arrives"), (VOLTS**3, NO_LAW)],
)  # fmt: skip
def test_what_is_no_motors_current_is_told_as_that(tmp_path, seen, said):
    assert said in law(tmp_path, drive=VOLTS, current=seen)


def test_noise_hides_what_it_hides(tmp_path):
    # 8 % of 0.6 A in noise of 0.8 A: the law with blocks left out scatters by more.
    assert law(tmp_path, drive=VOLTS, current=drawn(1.08 * VOLTS), noise=0.8) == AS_DECLARED
    assert BY_IT in law(tmp_path, drive=VOLTS, current=drawn(1.08 * VOLTS), noise=0.02)


def test_of_a_drive_of_one_sign_a_loss_may_be_the_zero(tmp_path):
    one_way = np.abs(VOLTS)
    assert law(tmp_path, drive=one_way, current=drawn(one_way)) == AS_DECLARED
    lost = law(tmp_path, drive=one_way, current=drawn(one_way - 1.5))
    assert "the zero (or what is told and never arrives) is -0.0999" in lost


def test_told_and_speed_that_go_together_tell_no_law(tmp_path):
    assert law(tmp_path, drive=0.1 * SPEED, current=drawn(0.1 * SPEED)) == NO_LAW
