"""The audit's checks notice a flipped sign, a missing factor or a changed digit."""

import pytest

from derivations import symbols as s
from derivations.audit import calibration, clutch_maps, dynamics, kinematics, static_torques
from derivations.audit.case_algebra import IN_A, IN_B, TAU
from derivations.audit.compare import rounds_to


@pytest.mark.parametrize("quarter_turns", [-3, 0, 1, 2, 4])
def test_only_minus_a_quarter_turn_repairs_equation_6(quarter_turns):
    right = quarter_turns % 4 == 3
    assert kinematics._theta_2_is_q1_plus_q2(quarter_turns) == right


def test_swapped_speeds_in_equation_15_are_noticed():
    assert dynamics._is_15(s.W1, s.W2, s.QDD)
    assert not dynamics._is_15(s.W2, s.W1, s.QDD)


def test_a_flipped_sign_in_equation_20_is_noticed():
    assert dynamics._link_torque(1, TAU[1] - TAU[2] + TAU[3] + IN_B, IN_B)
    assert not dynamics._link_torque(1, TAU[1] + TAU[2] + TAU[3] + IN_B, IN_B)


def test_the_sign_of_tau_3_is_decided_in_both_direct_cases():
    for stuck, sign in ((1, -1), (2, 1)):
        assert static_torques._direct_clutches(stuck, sign)
        assert not static_torques._direct_clutches(stuck, -sign)


@pytest.mark.parametrize("number", static_torques.PAIRS)
def test_a_flipped_load_in_a_resting_pair_is_noticed(number):
    stuck, printed = static_torques.PAIRS[number]
    assert static_torques._holds(stuck, printed)
    for symbol in (IN_A, IN_B):
        for torque, expression in printed.items():
            flipped = expression.subs(symbol, -symbol)
            if flipped != expression:
                assert not static_torques._holds(stuck, {torque: flipped})


def test_a_changed_digit_in_a_calibration_is_noticed():
    assert rounds_to(calibration.tachometer_gain(), "1.7453")
    assert not rounds_to(calibration.tachometer_gain(), "1.7454")


def test_a_changed_sum_in_table_4_is_noticed(monkeypatch):
    speeds = list(clutch_maps.TABLE_4)
    assert all(clutch_maps._table_4_row(speed) for speed in speeds)
    for speed in speeds:
        total, error = clutch_maps.TABLE_4[speed]
        wrong = str(float(total) * 1.3)
        monkeypatch.setitem(clutch_maps.TABLE_4, speed, (wrong, error))
        assert not clutch_maps._table_4_row(speed)


def test_the_inertia_of_a_solid_disc_is_not_that_of_a_ring():
    assert calibration._inertia_formula()
    assert not rounds_to(0.5 * 5.262 * 0.1397**2, "0.07522")
