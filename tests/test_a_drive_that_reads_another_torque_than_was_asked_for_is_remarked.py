"""In runs driven by a torque the motor's reading and its reference are compared without a model."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.signal import lfilter

from simpter_hybrid.identification.rotor.drive_reading import drive_remarks
from simpter_hybrid.identification.rotor.signals import RotorSignals


def recorded(gain, mode=1.0, zero=0.0, keeps=0.0):
    """Four runs with ramps of 20 N m, a row late; noise of 0.1 N m that `keeps` a part a row.

    `gain`: of all runs, or of each.
    """
    draw, runs = np.random.default_rng(4), []
    asked = np.concatenate([np.linspace(0.0, 20.0, 500), np.linspace(-5.0, 0.0, 500)])
    for of_run in np.broadcast_to(gain, 4):
        noise = lfilter([1.0], [1.0, -keeps], draw.normal(0.0, 0.1, asked.size))
        seen = zero + of_run * np.concatenate([[0.0], asked[:-1]]) + noise * (1 - keeps**2) ** 0.5
        told = {"motor_torque": seen, "reference_torque": asked, "servo_mode": np.full(1000, mode)}
        runs.append(SimpleNamespace(channels=told))
    return SimpleNamespace(runs=runs)


@pytest.mark.parametrize("gain", [1.03, 0.97])
def test_a_gain_of_three_per_cent_is_told(gain):
    (found,) = drive_remarks(recorded(gain), RotorSignals())
    # Noise of 0.1 N m on four thousand rows of some 9 N m: 0.0002.
    assert float(found.value.split()[0]) == pytest.approx(gain, abs=0.001)


@pytest.mark.parametrize(("surely", "told"), [(20.0, False), (25.0, False), (32.0, True)])
def test_chance_does_as_much_to_either_side_in_one_of_ten_thousand(surely, told):
    # Of four runs that is 28 standard errors of their mean; to one side 22.
    apart = 2.0 * 0.05 / surely * np.sqrt(0.75)
    gains = 1.05 + apart * np.array([-1.0, 1.0, -1.0, 1.0])
    assert bool(list(drive_remarks(recorded(gains), RotorSignals()))) is told


@pytest.mark.parametrize(("zero", "keeps"), [(0.0, 0.0), (1.0, 0.0), (0.0, 0.995)])
def test_one_that_reads_right_is_not_whatever_its_zero_or_noise(zero, keeps):
    assert not list(drive_remarks(recorded(1.0, zero=zero, keeps=keeps), RotorSignals()))


def test_a_servos_torque_has_no_reference():
    assert not list(drive_remarks(recorded(1.03, mode=0.0), RotorSignals()))
