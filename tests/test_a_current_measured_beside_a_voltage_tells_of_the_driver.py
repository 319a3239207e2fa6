"""What a motor draws tells of its driver, with no friction in it: SI numbers of a known motor."""

import numpy as np
import pytest
from motor_by_voltage import MAP as BY_DUTY
from motor_by_voltage import MODEL, K, R

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.axis.seen_drive import BY_IT, seen_drive
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.fitting_map import check_axis
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.cautions import driver_sentence
from simpter_hybrid.problems import InvalidInput

MAP = (
    BY_DUTY.partition("[channels.duty]")[0]
    + """
[channels.drive]
column = "volts"
unit = "V"
sign = 1
role = "input"
[channels.current]
column = "amps"
unit = "A"
sign = 1
role = "measured"
"""
)


def recorded(tmp_path, dead=0.0, constant=K, resistance=R, text=MAP):
    """Six seconds of a motor whose speed lags behind its voltage; noise of 10 mA."""
    time = 0.002 * np.arange(3000)
    volts, speed = 9.0 * np.sin(3.0 * time), 80.0 * np.sin(3.0 * time - 0.8)
    arrives = np.sign(volts) * np.maximum(np.abs(volts) - dead, 0.0)
    amps = (arrives - constant * speed) / resistance
    amps += 0.01 * np.random.default_rng(1).standard_normal(time.size)
    rows = np.column_stack([np.zeros(time.size), time, speed, volts, amps])
    (tmp_path / "map.toml").write_text(text)
    np.savetxt(
        tmp_path / "d.csv", rows, "%.6g", ",", header="take,s,rate,volts,amps", comments=""
    )  # fmt: skip
    return as_axis(load_recording([tmp_path / "d.csv"], tmp_path / "map.toml"))


@pytest.mark.parametrize(
    ("other", "told"),
    [
        ({}, "it goes with a driver and a motor as declared"),
        ({"dead": 1.0}, "V of what is told never arrive"),
        ({"resistance": 1.2 * R}, "by it the motor's resistance is 18"),
        ({"constant": 0.8 * K}, "by it the motor's constant is 0.048"),
    ],
)
def test_it_says_what_is_not_as_declared(tmp_path, other, told):
    recording = recorded(tmp_path, **other)
    (remark,) = seen_drive(recording, parse(MODEL, "m.toml"), AxisSignals())
    assert remark.what.startswith("current is not compared")
    assert told in remark.value
    assert remark.value.startswith(BY_IT) == bool(other)
    assert not other or " and " not in remark.value, "nothing else is off"
    assert bool(driver_sentence([remark])) == bool(other)


def test_the_lost_voltage_is_the_dead_band(tmp_path):
    recording = recorded(tmp_path, dead=1.0)
    (remark,) = seen_drive(recording, parse(MODEL, "m.toml"), AxisSignals())
    lost = float(remark.value.removeprefix(BY_IT).split()[0])
    assert lost == pytest.approx(1.0, abs=0.05)  # noise of 10 mA in 15 ohm: 0.15 V a row


def test_the_voltage_drives_and_the_current_is_no_drive(tmp_path):
    recording = recorded(tmp_path)
    assert AxisSignals().driving(recording) == "drive"
    assert not AxisSignals().sensed & recording.channels.keys()
    check_axis(recording, parse(MODEL, "m.toml"))


def test_two_inputs_that_drive_are_refused(tmp_path):
    both = 'role = "input"'.join(MAP.rsplit('role = "measured"', 1))
    with pytest.raises(InvalidInput, match="several drive the axis"):
        check_axis(recorded(tmp_path, text=both), parse(MODEL, "m.toml"))


def test_a_motor_of_known_current_asks_for_the_current(tmp_path):
    by_current = MODEL.replace("voltage-drive", "current-drive").replace(
        f'resistance = "{R} ohm"\n', ""
    )
    with pytest.raises(InvalidInput, match='role = "input" of channel current'):
        check_axis(recorded(tmp_path), parse(by_current, "m.toml"))
