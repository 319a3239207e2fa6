"""Passive, breakaway at least slip at 0+: where a torque map fails, and with which values."""

import dataclasses
import re
from dataclasses import dataclass

import pytest

from simpter_hybrid.checks.law_check import check_law
from simpter_hybrid.clutch import TorqueLaw
from simpter_hybrid.laws import LBF_IN, LinearTorque, ModifiedQuadratic, TestbedTorque
from simpter_hybrid.laws.table_torque import TableTorque

#: Thesis Table 3: speed [rad/s] and coefficients of v^2, v, 1 [lb-in].
TABLE_3 = [
    (0.194, 6.060, -0.193, 1.496),
    (0.394, 6.439, 0.137, 0.371),
    (0.792, 6.834, 2.167, -1.102),
    (1.193, 7.158, 3.143, -2.405),
    (1.590, 6.954, 5.445, -3.899),
    (1.990, 7.462, 4.312, -2.711),
]


@pytest.mark.parametrize(
    "law",
    [
        TestbedTorque(),
        LinearTorque(5.0),
        LinearTorque(5.0, ratio=1.3),
        ModifiedQuadratic(2.0, -12.0, 22.0, 2.5, -10.0, 15.0),
        TableTorque(((0.0, 0.0, 0.0), (10.0, 5.0, 6.0))),
    ],
)
def test_sound_maps_pass(law):
    assert check_law(law, 10.0) == []


@pytest.mark.parametrize(("speed", "a", "b", "c"), TABLE_3)
def test_of_the_fits_of_table_3_those_with_a_negative_intercept_fail(speed, a, b, c):
    law = dataclasses.replace(TestbedTorque(), a=a * LBF_IN, b=b * LBF_IN, c=c * LBF_IN)
    found = check_law(law, 10.0)
    assert [f.what for f in found if "negative" in f.what] == (
        ["the slip torque is negative"] if c < 0.0 else []
    )


def test_it_is_told_where_breakaway_falls_below_slip_and_by_how_much():
    # breakaway - slip = (v - 4)^2/10 - 0.1: worst at 4 V, by 0.1 N m.
    found = check_law(Crossing(), 10.0)
    assert [f.what for f in found] == ["the breakaway torque is below the slip torque"]
    pattern = r"([\d.]+) N\*m .* < ([\d.]+) N\*m .* at ([\d.]+) V"
    low, high, at = map(float, re.match(pattern, found[0].value).groups())
    assert at == pytest.approx(4.0, abs=1e-3)
    # Four and six digits are printed.
    assert high - low == pytest.approx(0.1, abs=2e-5)


@dataclass(frozen=True)
class Crossing(TorqueLaw):
    @staticmethod
    def slip_torque(excitation):
        return 1.0 + excitation

    @staticmethod
    def break_torque(excitation):
        return 0.9 + excitation + 0.1 * (excitation - 4.0) ** 2


@dataclass(frozen=True)
class Fading(TorqueLaw):
    @staticmethod
    def slip_torque(speed, excitation):
        return excitation * (1.0 - 0.2 * speed)

    @staticmethod
    def break_torque(excitation):
        return 2.0 * excitation


@dataclass(frozen=True)
class Failing(TorqueLaw):
    @staticmethod
    def slip_torque(excitation):
        return 1.0 / (excitation - 5.0)

    @staticmethod
    def break_torque(excitation):
        return 1.0


def test_a_torque_that_turns_negative_at_speed_is_found():
    (finding,) = check_law(Fading(), 10.0)
    assert finding.what == "the slip torque is negative"
    assert "at 10 V and 20 rad/s" in finding.value


def test_a_map_that_raises_is_found_not_raised():
    (finding,) = check_law(Failing(), 10.0)
    assert finding.what.startswith("the slip torque fails (ZeroDivisionError")
    assert "at 5 V" in finding.value
