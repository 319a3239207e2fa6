"""One clutch: Karnopp's events against formulas.

A clutch is released where its torque reaches the breakaway level, which the band does not delay;
but inside the band it goes on giving the breakaway torque. Without a gap to the slip torque that
makes no difference; with one, the slip starts late by the time that it takes to leave the band.
"""

from importlib.util import find_spec

import pytest
from devices_for_tests import Block, Ramp, always_on
from exact_runs import coulomb_oscillator

from simpter_hybrid.karnopp import simulate
from simpter_hybrid.scenario import Scenario

#: Either way to the same bits, in a tenth of the time.
COMPILED = find_spec("llvmlite") is not None
ON = {"command": (1.0,), "excitation": (1.0,)}


def final_error(band: float, brk: float) -> float:
    """Error of the position of a block that a ramp of 1 N/s moves from t = brk [s] on."""
    run = Scenario(
        "ramp", Block(2.0), (always_on(1.0, brk),), (0.0,), (0.0,), 3.0,
        loads=(Ramp(0.0, ((0.0, 0.0), (3.0, 3.0))),), **ON,
    )  # fmt: skip
    found = simulate(run, band, solver="fixed", step=5e-4, compiled=COMPILED)
    assert [e.kind for e in found.events] == ["start", "breakaway"]
    # The solver's step, at whose end the change is seen.
    assert found.events[1].t == pytest.approx(brk, abs=5.1e-4)
    last = 3.0 - brk
    # x'' = (t - 1) / 2 from t = brk on.
    exact = (last**3 / 6.0 + (brk - 1.0) * last**2 / 2.0) / 2.0
    return found.end[0] - exact


def test_without_a_gap_the_band_costs_nothing():
    # The step that ends after the breakaway: h^2 of acceleration's slope, times the time left.
    assert abs(final_error(1e-1, 1.0)) < 1e-6


def test_with_a_gap_the_slip_is_late_in_proportion_to_the_square_root_of_the_band():
    # In the band only the excess over breakaway, t - brk, accelerates: x' = (t - brk)^2 / 4.
    errors = [final_error(band, 1.3) for band in (4e-2, 1e-2, 2.5e-3)]
    for band, error in zip((4e-2, 1e-2, 2.5e-3), errors, strict=True):
        late = (4.0 * band) ** 0.5
        # Speed lost is gap * late / mass = 0.15 late, kept over 1.7 s; the rest is of second order.
        assert error == pytest.approx(-0.15 * late * 1.7, rel=0.15 * late / 0.2)
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.1)
    assert errors[1] / errors[2] == pytest.approx(2.0, rel=0.1)


def test_an_oscillator_comes_to_rest_where_the_formula_says():
    run, expected = coulomb_oscillator()
    found = simulate(run, 1e-5, rtol=1e-9, atol=1e-12, compiled=COMPILED)
    assert found.status == "finished"
    # Turning points lie half a period apart, each 2 slip / k nearer: 2 - 0.28 count.
    reach = 2.0 - 2.0 * 0.7 / 5.0 * len(expected)
    assert abs(found.end[0]) == pytest.approx(reach, abs=1e-5)
