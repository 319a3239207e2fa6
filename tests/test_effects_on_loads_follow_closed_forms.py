"""Every effect that is a force or an inertia against a formula of motion."""

from math import asinh, cos, exp, hypot, log, pi, sin, sqrt

import pytest
from devices_for_tests import Coulomb, Ramp

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.added_inertia import AddedInertia
from simpter_hybrid.effects.bias_drift import BiasDrift
from simpter_hybrid.effects.bias_force import BiasForce
from simpter_hybrid.effects.by_temperature import DragByTemperature
from simpter_hybrid.effects.dry_drag import DryDrag
from simpter_hybrid.effects.eddy_drag import EddyDrag
from simpter_hybrid.effects.end_spring import EndSpring
from simpter_hybrid.effects.imbalance import Imbalance
from simpter_hybrid.effects.power_law_drag import PowerLawDrag
from simpter_hybrid.effects.quadratic_drag import QuadraticDrag
from simpter_hybrid.effects.ripple_force import RippleForce
from simpter_hybrid.effects.spring_force import SpringForce
from simpter_hybrid.effects.tabulated_force import TabulatedForce
from simpter_hybrid.effects.viscous_drag import ViscousDrag
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.scenario import Scenario

#: Inertia [kg m^2], angle and speed at the start, duration [s].
J, ANGLE, SPEED, T = 0.3, 0.4, 2.0, 1.5
#: Solver tolerance 1e-10 a step, some tens of steps.
CLOSE = 1e-8


def spin(effect, loads=(), speed=SPEED):
    run = simulate(
        Scenario(
            "spin",
            Testbed(J),
            (Clutch(Coulomb(1.0, 1.0)),),
            (ANGLE,),
            (speed,),
            T,
            loads=loads,
            effects=(effect,),
        )
    )
    assert energy_balance(run).relative < CLOSE
    return run


def test_viscous_drag_slows_exponentially():
    speed = spin(ViscousDrag(coordinate=0, coefficient=0.2)).end[1]
    assert speed == pytest.approx(SPEED * exp(-0.2 * T / J), rel=CLOSE)


def test_drag_that_falls_with_temperature_slows_as_its_mean_does():
    # Warmer than the reference first, then colder; level at both ends, so with a mean halfway.
    points = ((0.0, 303.0), (T, 273.0))
    effect = DragByTemperature(coordinate=0, change=-0.02, reference=293.0, points=points)
    assert spin(effect).end[1] == pytest.approx(SPEED * exp(0.02 * -5.0 * T / J), rel=CLOSE)


def test_quadratic_drag_slows_hyperbolically():
    speed = spin(QuadraticDrag(coordinate=0, coefficient=0.2)).end[1]
    assert speed == pytest.approx(SPEED / (1.0 + 0.2 * SPEED * T / J), rel=CLOSE)


@pytest.mark.parametrize("exponent", [1.5, 3.0])
@pytest.mark.parametrize("turned", [1.0, -1.0])
def test_drag_by_a_power_slows_as_its_integral_says(exponent, turned):
    effect = PowerLawDrag(coordinate=0, level=0.3, scale=2.0, exponent=exponent)
    less = exponent - 1.0  # of v' = -k v^n:  v^-(n-1) = v0^-(n-1) + (n - 1) k t
    slowed = SPEED**-less + less * 0.3 / 2.0**exponent * T / J
    assert spin(effect, speed=turned * SPEED).end[1] == pytest.approx(
        turned * slowed ** (-1.0 / less), rel=CLOSE
    )


@pytest.mark.parametrize("critical", [0.2 * SPEED, SPEED, 5.0 * SPEED])
def test_eddy_drag_slows_as_its_integral_says(critical):
    x = spin(EddyDrag(coordinate=0, peak=0.3, critical=critical)).end[1] / critical
    first = SPEED / critical
    passed = log(first / x) + (first**2 - x**2) / 2.0
    assert passed == pytest.approx(2.0 * 0.3 * T / (J * critical), rel=CLOSE)


def test_dry_drag_slows_as_its_integral_says():
    level, width = 0.3, 0.5

    def integral(v):  # of hypot(v, width)/v
        return hypot(v, width) - width * asinh(width / v)

    speed = spin(DryDrag(coordinate=0, level=level, width=width)).end[1]
    assert integral(SPEED) - integral(speed) == pytest.approx(level * T / J, rel=CLOSE)


def test_a_bias_accelerates_evenly():
    angle = spin(BiasForce(coordinate=0, bias=-0.5)).end[0]
    assert angle == pytest.approx(ANGLE + SPEED * T - 0.25 * T**2 / J, rel=CLOSE)


def test_a_bias_that_grows_with_time_accelerates_more_and_more():
    angle = spin(BiasDrift(coordinate=0, bias=-0.5, rate=-0.3)).end[0]
    expected = ANGLE + SPEED * T - 0.25 * T**2 / J - 0.3 * T**3 / (6.0 * J)
    assert angle == pytest.approx(expected, rel=CLOSE)


def test_a_spring_makes_an_oscillator():
    rate = sqrt(4.0 / J)
    angle = spin(SpringForce(coordinate=0, stiffness=4.0, rest=0.1)).end[0]
    expected = 0.1 + 0.3 * cos(rate * T) + SPEED / rate * sin(rate * T)
    assert angle == pytest.approx(expected, rel=CLOSE)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_spring_at_one_end_throws_back_after_half_an_oscillation(side):
    rate, way = sqrt(40.0 / J), 0.5
    edge = ANGLE + side * way
    effect = EndSpring(coordinate=0, stiffness=40.0, edge=edge, side=side)
    angle, speed = spin(effect, speed=side * SPEED).end[:2]
    assert speed == pytest.approx(-side * SPEED, rel=CLOSE)
    back = T - way / SPEED - pi / rate
    assert angle == pytest.approx(edge - side * SPEED * back, rel=CLOSE)


def test_a_tabulated_force_on_a_straight_line_is_a_spring():
    rate = sqrt(4.0 / J)
    angle = spin(TabulatedForce(coordinate=0, weight=0.5, points=((-2, 16), (2, -16)))).end[0]
    assert angle == pytest.approx(ANGLE * cos(rate * T) + SPEED / rate * sin(rate * T), rel=CLOSE)


def test_inertia_that_is_added_is_accelerated_as_well():
    load = (Ramp(0.0, ((0.0, 0.7), (9.0, 0.7))),)
    speed = spin(AddedInertia(coordinate=0, inertia_change=0.2), load).end[1]
    assert speed == pytest.approx(SPEED + 0.7 * T / (J + 0.2), rel=CLOSE)


@pytest.mark.parametrize(
    ("effect", "potential"),
    [
        (Imbalance(coordinate=0, cosine=0.3, sine=-0.2), lambda q: -0.3 * sin(q) - 0.2 * cos(q)),
        (
            RippleForce(coordinate=0, cosine=0.3, sine=0.1, number=6.0),
            lambda q: (-0.3 * sin(6 * q) + 0.1 * cos(6 * q)) / 6.0,
        ),
    ],
    ids=lambda x: type(x).__name__,
)
def test_forces_by_position_keep_their_energy(effect, potential):
    run = spin(effect)
    q, v = run.end[0], run.end[1]
    gained = 0.5 * J * (v**2 - SPEED**2)
    assert gained == pytest.approx(potential(ANGLE) - potential(q), rel=CLOSE, abs=1e-9)
    assert abs(q - ANGLE) > 0.1 * pi


@pytest.mark.parametrize("side", [0.0, 0.5])
def test_a_spring_at_an_end_is_on_one_side(side):
    with pytest.raises(ValueError, match="side: neither 1"):
        EndSpring(coordinate=0, stiffness=1.0, edge=0.0, side=side)
