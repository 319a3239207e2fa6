"""Thesis Figures 41 and 42: command = table(desired) + gain (desired - |torque|), 0 to 10 V."""

import pytest
from pter_control import INCH, LBF, LINE, Instants, scenario

from simpter_hybrid.controllers.impedance import ImpedanceToLine
from simpter_hybrid.controllers.lookup import LookupTable
from simpter_hybrid.controllers.torque_feedback import TorqueFeedback
from simpter_hybrid.laws import LBF_IN

SELECTOR = ImpedanceToLine(32 * LBF / INCH, 0.7 * LBF / INCH, **LINE)
TABLE = LookupTable(600 * LBF_IN)
GAIN = 0.16 / LBF_IN
STATE = ((0.731, 1.583), (0.4, -0.3))
TORQUES = (-3.0, 8.0, -40.0, 0.5)


def commands(*after):
    return Instants(scenario(SELECTOR, TABLE, *after))(*STATE, tau=TORQUES)


def test_sum_and_saturation():
    table, desired = commands()
    found, _ = commands(TorqueFeedback(GAIN))
    right = [
        min(max(v + GAIN * (d - abs(t)), 0.0), 10.0)
        for v, d, t in zip(table, desired, TORQUES, strict=False)
    ]
    assert found == pytest.approx(right, rel=1e-14)
    assert 0.0 in right
    assert any(0.0 < v < 10.0 for v in right)


def test_gain_zero_is_the_table_alone():
    assert commands(TorqueFeedback(0.0))[0] == commands()[0]


def test_full_voltage_is_the_most():
    found, _ = commands(TorqueFeedback(100.0 * GAIN))
    assert max(found) == 10.0
