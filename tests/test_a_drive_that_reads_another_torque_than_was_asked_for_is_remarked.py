"""In runs driven by a torque the motor's reading and its reference are compared without a model."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.rotor.drive_reading import drive_remarks
from simpter_hybrid.identification.rotor.signals import RotorSignals


def recorded(gain, mode=1.0):
    """Ramps of 20 N m, a row late and with noise of 0.3 N m, and one jump."""
    draw = np.random.default_rng(4)
    asked = np.concatenate([np.linspace(0.0, 20.0, 500), np.linspace(-5.0, 0.0, 500)])
    seen = gain * np.concatenate([[0.0], asked[:-1]]) + draw.normal(0.0, 0.3, asked.size)
    told = {"motor_torque": seen, "reference_torque": asked, "servo_mode": np.full(1000, mode)}
    return SimpleNamespace(runs=[SimpleNamespace(channels=told)])


@pytest.mark.parametrize("gain", [1.03, 0.97])
def test_a_gain_of_three_per_cent_is_told(gain):
    (found,) = drive_remarks(recorded(gain), RotorSignals())
    # Noise of 0.3 N m on a thousand rows of some 9 N m: 0.001.
    assert float(found.value.split()[0]) == pytest.approx(gain, abs=0.004)


def test_one_that_reads_right_is_not_remarked():
    assert not list(drive_remarks(recorded(1.0), RotorSignals()))


def test_a_servos_torque_has_no_reference():
    assert not list(drive_remarks(recorded(1.03, mode=0.0), RotorSignals()))
