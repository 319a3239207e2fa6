"""Chapter 4's printed fits and step responses against the declared clutch, and what they lack."""

from math import exp, log

import numpy as np
import pytest

from simpter_hybrid.reproduce import measured_steps as steps
from simpter_hybrid.reproduce import measured_torque as torque
from simpter_hybrid.reproduce.friction_fits import BASE, FITS, TABLE_4, polynomial


def test_sums_of_squares_of_the_lost_points_are_those_of_table_4():
    x = np.array(torque.PRINTED)
    found = torque.squares(torque.FORMS[0], x, list(range(6)))
    # Coefficients are printed to three decimals: 5 % of a speed, 1 % of all.
    assert found == pytest.approx([sse for sse, _ in TABLE_4], rel=0.05)
    assert found.sum() == pytest.approx(sum(sse for sse, _ in TABLE_4), rel=0.01)


def test_39_lies_above_the_data_at_both_ends_of_its_speeds():
    base = polynomial(BASE)
    factors = np.array([base @ polynomial(fit) for fit in FITS]) / float(base @ base)
    course = factors / (torque.PRINTED[0] * np.array(torque.SPEEDS) + torque.OFFSET)
    assert (course[[0, -1]] < 1.0).all()
    assert (course[2:4] > 1.0).all()


def test_a_logarithm_of_speed_foretells_a_speed_left_out():
    plain, logarithmic = (torque.judge(form) for form in torque.FORMS[:2])
    assert logarithmic.left_out < 0.7 * plain.left_out
    assert logarithmic.lack_of_fit > 2.2  # 1 % level of F(14, 228): its form is incomplete


def test_the_response_to_a_step_is_that_of_a_lag_in_closed_form():
    law = steps.TestbedTorque()
    volts, constant = 8.0, 0.07

    def reached(share: float) -> float:
        """Instant at which the quadratic has made this share of its change, by its root."""
        full = (law.a * volts + law.b) * volts
        v = (-law.b + (law.b**2 + 4.0 * law.a * share * full) ** 0.5) / (2.0 * law.a)
        return -constant * log(1.0 - v / volts)

    delay, rise = steps.response(steps.DECLARED, 0.0, volts)
    # Followed for 0.5 s: 0.08 % of the step is still to come; and steps of 0.5 ms.
    assert delay == pytest.approx(0.02 + reached(0.001), abs=1e-4)
    assert rise == pytest.approx(reached(1.0 - exp(-1.0)) - reached(0.001), abs=3e-4)


def test_a_supply_that_saturates_explains_the_steps_and_a_lag_does_not():
    plain = steps.FORMS[0]
    coil = next(form for form in steps.FORMS if form.name.startswith("coil-supply"))
    before, after = (steps.rms(steps.errors(f.make(steps.fitted(f)))) for f in (plain, coil))
    assert after < 0.2 * before
