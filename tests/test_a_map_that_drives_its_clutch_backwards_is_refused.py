"""A clutch takes energy whichever way it slips, so a map is judged both ways."""

from dataclasses import dataclass

from simpter_hybrid.checks.law_check import check_law
from simpter_hybrid.clutch import TorqueLaw


@dataclass(frozen=True)
class OneWay(TorqueLaw):
    @staticmethod
    def slip_torque(excitation, direction):
        return excitation * (1.0 if direction > 0.0 else -0.5)

    break_torque = slip_torque


def test_its_negative_torque_is_told_with_the_way():
    (finding,) = check_law(OneWay(), 10.0)
    assert finding.what == "the slip torque is negative"
    assert finding.value.startswith("-5 N*m")
    assert finding.value.endswith("at 10 V and 0 rad/s backwards")
