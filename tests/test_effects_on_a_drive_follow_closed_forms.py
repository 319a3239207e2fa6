"""DriveLag and DriveGain against closed forms of a mass that a servo at its limit pushes."""

from math import cos, exp, sin

import pytest
from devices_for_tests import Coulomb
from scipy.integrate import solve_ivp

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.axis_servo import PositionServo
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.drive_deadband import DriveDeadband
from simpter_hybrid.effects.drive_gain import DriveGain
from simpter_hybrid.effects.drive_lag import DriveLag
from simpter_hybrid.effects.drive_limit import DriveLimit
from simpter_hybrid.effects.drive_released import DriveReleased
from simpter_hybrid.effects.drive_ripple import DriveRipple
from simpter_hybrid.effects.drive_saturation import DriveSaturation
from simpter_hybrid.effects.winding_heat import WindingHeat
from simpter_hybrid.engine import simulate
from simpter_hybrid.loads.drive import ForceDrive, VoltageDrive
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.scenario import Scenario

#: Inertia [kg m^2], limit of the servo [V], torque a volt [N m/V], lag and duration [s].
J, U, K, LAG, T = 0.3, 2.0, 1.5, 0.2, 0.9
#: Solver tolerance 1e-10 a step, some tens of steps.
CLOSE = 1e-8


def pushed(release, lag=LAG, sign=1.0, effect=None, motor=None):
    """Speed at the end under a servo at its limit whose terminals open at an instant."""
    effect = effect or DriveLag(coordinate=0, lag=lag, constant=K)
    servo = PositionServo(((0.0, 1e6 * sign), (1.0, 1e6 * sign)), 1.0, limit=U, release=release)
    scenario = Scenario(
        "pushed", Testbed(J), (Clutch(Coulomb(1.0, 1.0)),), (0.0,), (0.0,), T,
        (motor or ForceDrive(K),),
        ((servo, 1),), (effect,), period=0.1,
    )  # fmt: skip
    run = simulate(scenario)
    assert energy_balance(run).relative < CLOSE
    return run.end[1]


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_lag_takes_its_time_constant_from_the_impulse(sign):
    expected = sign * K * U / J * (T - LAG * (1.0 - exp(-T / LAG)))
    assert pushed(1e300, sign=sign) == pytest.approx(expected, rel=CLOSE)


def test_a_gain_gives_so_much_more_while_the_drive_is_on():
    effect = DriveGain(coordinate=0, gain=0.25, constant=K)
    assert pushed(0.45, effect=effect) == pytest.approx(1.25 * K * U / J * 0.5, rel=CLOSE)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(
    ("effect", "part"),
    [
        (DriveDeadband(coordinate=0, width=0.25 * U, constant=K), 0.75),
        (DriveLimit(coordinate=0, limit=0.6 * U, constant=K), 0.6),
        (DriveSaturation(coordinate=0, fall=0.25, most=U, constant=K), 0.8),
        (DriveSaturation(coordinate=0, fall=0.25, most=2.0 * U, constant=K), 16.0 / 17.0),
    ],
)
def test_a_dead_band_takes_its_width_and_a_limit_what_is_above_it_either_way(effect, part, sign):
    expected = part * sign * K * U / J * T
    assert pushed(1e300, sign=sign, effect=effect) == pytest.approx(expected, rel=CLOSE)


def test_a_ripple_of_the_drive_does_the_work_of_its_wave():
    effect = DriveRipple(coordinate=0, cosine=0.3, sine=-0.2, number=4.0, constant=K)
    servo = PositionServo(((0.0, 1e6), (1.0, 1e6)), 1.0, limit=U)
    run = simulate(
        Scenario(
            "pushed", Testbed(J), (Clutch(Coulomb(1.0, 1.0)),), (0.0,), (0.0,), T,
            (ForceDrive(K),), ((servo, 1),), (effect,), period=0.1,
        )
    )  # fmt: skip
    way, speed = run.end[:2]
    assert 4.0 * way > 6.3  # more than a wave
    work = K * U * (way + 0.3 * sin(4.0 * way) / 4.0 - 0.2 * (1.0 - cos(4.0 * way)) / 4.0)
    assert 0.5 * J * speed**2 == pytest.approx(work, rel=CLOSE)


def test_what_is_within_a_dead_band_moves_nothing():
    effect = DriveDeadband(coordinate=0, width=1.5 * U, constant=K)
    assert pushed(1e300, effect=effect) == pytest.approx(0.0, abs=CLOSE)


def test_a_limit_of_current_ends_where_the_speed_makes_up_for_it():
    # The motor turns against its own voltage: cut until back speed = K (U - limit), then as a lag.
    motor, back = VoltageDrive(1.5, 1.5 / K), 1.5 * K
    limit = 0.4 * U
    until = K * (U - limit) / back / (K * limit / J)
    assert until < T
    rest, rate = T - until, back / J
    top = K * U / back
    expected = top - (top - K * (U - limit) / back) * exp(-rate * rest)
    effect = DriveLimit(coordinate=0, limit=limit, constant=K, back=back)
    assert pushed(1e300, effect=effect, motor=motor) == pytest.approx(expected, rel=CLOSE)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(("below", "share", "part"), [(U, 0.4, 0.6), (0.99 * U, 1.0, 1.0)])
def test_a_motor_let_go_of_gives_so_much_less_where_no_more_is_told(below, share, part, sign):
    motor, back = VoltageDrive(1.5, 1.5 / K), 1.5 * K
    effect = DriveReleased(coordinate=0, share=share, below=below, constant=K, back=back)
    expected = sign * K * U / back * (1.0 - exp(-part * back / J * T))
    assert pushed(1e300, sign=sign, effect=effect, motor=motor) == pytest.approx(
        expected, rel=CLOSE
    )


def test_without_a_lag_the_drive_is_as_told():
    assert pushed(1e300, lag=0.0) == pytest.approx(K * U / J * T, rel=CLOSE)


def test_a_released_drive_does_nothing_at_once():
    # The servo is asked at 0.0, 0.1 ... 0.5, where its terminals open.
    expected = K * U / J * (0.5 - LAG * (1.0 - exp(-0.5 / LAG)))
    assert pushed(0.45) == pytest.approx(expected, rel=CLOSE)


def test_a_winding_that_warms_follows_its_own_equations():
    motor, back, energy, cooling = VoltageDrive(1.5, 1.5 / K), 1.5 * K, 0.2, 0.7
    effect = WindingHeat(
        coordinate=0, rise=0.8, energy=energy, cooling=cooling, constant=K, back=back
    )

    def rates(_, state):
        speed, heat = state
        cold, more = K * U - back * speed, 1.0 + 0.8 * heat / energy
        return [cold / more / J, cold**2 / back / more - heat / cooling]

    expected = solve_ivp(rates, (0.0, T), [0.0, 0.0], rtol=1e-11, atol=1e-12).y[0, -1]
    assert pushed(1e300, effect=effect, motor=motor) == pytest.approx(expected, rel=CLOSE)
    cold = K * U / back * (1.0 - exp(-back / J * T))
    assert expected < 0.99 * cold
