"""A motor's constant that is far off looks like a wrong map: it is named beside the columns."""

from types import SimpleNamespace

from axis_recordings import declared_axis

from simpter_hybrid.identification.hopeless import _of_the_drive
from simpter_hybrid.loads.drive import VoltageDrive


def test_what_the_model_has_is_said():
    motor = VoltageDrive(constant=0.1, resistance=7.5)
    said = _of_the_drive(SimpleNamespace(loads=(motor,)))
    assert "load.1.constant (0.1 in SI units) and load.1.resistance (7.5 in SI units)" in said
    assert "a wider tolerance lets one be fitted" in said


def test_a_force_that_a_sensor_saw_has_none():
    assert _of_the_drive(declared_axis()) == ""
