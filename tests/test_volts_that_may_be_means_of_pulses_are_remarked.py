"""Whether a driver opens the motor between its pulses is asked where their height is known."""

from dataclasses import replace

import numpy as np
from motor_by_voltage import MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.motor import pulses_untold, with_pulses
from simpter_hybrid.loads.drive import ForceDrive

MOTOR = parse(MODEL, "m.toml")


def test_without_a_height_it_is_said_that_this_is_not_tried():
    (remark,) = pulses_untold(MOTOR)
    assert "drive-coasting" in remark.what
    assert "duty and supply" in remark.right


def test_with_one_or_another_kind_of_drive_nothing_is():
    assert pulses_untold(with_pulses(MOTOR, np.array([12.0, 12.1]))) == ()
    assert pulses_untold(replace(MOTOR, loads=(ForceDrive(1.0),))) == ()
