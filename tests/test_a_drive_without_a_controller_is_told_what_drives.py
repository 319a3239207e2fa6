import pytest

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.problems import InvalidInput

TEXT = """
[run]
t_end = "1 s"
[start]
coordinates = ["0 rad"]
[device]
kind = "one-axis"
inertia = "4e-5 kg*m^2"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "0.015 N*m" }
[[loads]]
kind = "voltage-drive"
constant = "0.11 N*m/A"
resistance = "10 ohm"
"""


def test_a_drive_without_a_controller_is_told_what_drives() -> None:
    with pytest.raises(InvalidInput, match='such as kind = "position-servo"; in a diagnosis the'):
        parse(TEXT)
