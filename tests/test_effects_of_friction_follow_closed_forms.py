"""Every effect on friction against a formula, a quadrature, or a limit."""

from math import cos, exp, log, pi, sin, sqrt

import numpy as np
import pytest
from devices_for_tests import Block, Ramp, always_on
from scipy.integrate import quad
from scipy.optimize import brentq

from simpter_hybrid.effects.asymmetry import Asymmetry
from simpter_hybrid.effects.bias_force import BiasForce
from simpter_hybrid.effects.bristles import Bristles
from simpter_hybrid.effects.by_temperature import FrictionByTemperature
from simpter_hybrid.effects.dahl import Dahl
from simpter_hybrid.effects.degressive_speed import DegressiveSpeed
from simpter_hybrid.effects.drift import Drift
from simpter_hybrid.effects.dwell_breakaway import DwellBreakaway
from simpter_hybrid.effects.logarithmic_speed import LogarithmicSpeed
from simpter_hybrid.effects.lugre import LuGre
from simpter_hybrid.effects.position_friction import PositionFriction
from simpter_hybrid.effects.rate_breakaway import RateBreakaway
from simpter_hybrid.effects.reset_integrator import ResetIntegrator
from simpter_hybrid.effects.settling import Settling
from simpter_hybrid.effects.stribeck import Stribeck
from simpter_hybrid.effects.surface_wave import SurfaceWave
from simpter_hybrid.effects.tabulated_friction import TabulatedFriction
from simpter_hybrid.effects.thermal_fade import ThermalFade
from simpter_hybrid.effects.warm_up import WarmUp
from simpter_hybrid.effects.wear_in import WearIn
from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

#: Mass [kg], slip and breakaway force [N], speed at the start [m/s].
MASS, SLIP, BREAK, SPEED = 1.5, 2.0, 2.6, 1.2
#: Solver tolerance 1e-10 a step, some tens of steps.
CLOSE = 1e-8


def block(effect, speed=SPEED, loads=(), t_end=5.0, mass=MASS, brk=BREAK, stiffness=0.0):
    run = Scenario(
        "block", Block(mass, stiffness), (always_on(SLIP, brk),), (0.0,), (speed,), t_end
    )
    return simulate(run.replace(loads=loads, effects=(effect,), command=(1.0,), excitation=(1.0,)))


def stop_of(run):
    return next(e.t for e in run.events if e.kind == "slip stop")


def breakaway_of(run):
    return next(e.t for e in run.events if e.kind == "breakaway")


def test_stribeck_stops_a_block_when_its_integral_says():
    rise, fade = 0.4, 0.3
    run = block(Stribeck(clutch=0, rise=rise, fade=fade), brk=4.0)
    time = MASS / SLIP * fade * log((exp(SPEED / fade) + rise) / (1.0 + rise))
    assert stop_of(run) == pytest.approx(time, rel=CLOSE)


@pytest.mark.parametrize(
    ("effect", "factor"),
    [
        (
            Stribeck(clutch=0, rise=0.3, fade=0.2, shape=2.0),
            lambda v: 1 + 0.3 * exp(-((v / 0.2) ** 2)),
        ),
        (LogarithmicSpeed(clutch=0, rise=0.1, scale=0.05), lambda v: 1 + 0.1 * log(1 + v / 0.05)),
        (DegressiveSpeed(clutch=0, rise=0.5, scale=0.2), lambda v: 1 + 0.5 * v / (v + 0.2)),
    ],
    ids=lambda x: type(x).__name__,
)
def test_speed_dependent_friction_stops_a_block_when_quadrature_says(effect, factor):
    time = MASS / SLIP * quad(lambda v: 1.0 / factor(v), 0.0, SPEED, epsabs=1e-13)[0]
    assert stop_of(block(effect)) == pytest.approx(time, rel=CLOSE)


def test_tabulated_friction_on_a_straight_line_stops_a_block_when_its_integral_says():
    rise = 0.3
    run = block(TabulatedFriction(clutch=0, weight=0.5, points=((0.0, 0.0), (2.0, 4.0 * rise))))
    assert stop_of(run) == pytest.approx(MASS / SLIP / rise * log(1.0 + rise * SPEED), rel=CLOSE)


def test_asymmetric_friction_stops_a_block_sooner_one_way_than_the_other():
    effect = Asymmetry(clutch=0, share=0.2)
    for way in (1.0, -1.0):
        time = MASS * SPEED / (SLIP * (1.0 + 0.2 * way))
        assert stop_of(block(effect, speed=way * SPEED)) == pytest.approx(time, rel=CLOSE)


def test_friction_with_another_level_each_way_moves_as_with_a_constant_force():
    for way in (1.0, -1.0):
        level = block(Asymmetry(clutch=0, level=0.3), speed=way * SPEED)
        force = block(BiasForce(coordinate=0, bias=-0.3), speed=way * SPEED)
        assert stop_of(level) == pytest.approx(stop_of(force), rel=CLOSE)


def test_position_dependent_friction_stops_a_block_where_the_energy_is_used_up():
    effect = PositionFriction(clutch=0, once_cos=0.3, often_sin=0.2, number=5.0)
    run = block(effect)

    def work(x):
        return SLIP * (x + 0.3 * sin(x) + 0.2 * (1.0 - 1.0 + 2.0 * sin(2.5 * x) ** 2) / 5.0)

    where = brentq(lambda x: work(x) - 0.5 * MASS * SPEED**2, 0.0, 2.0, xtol=1e-14)
    assert run.end[0] == pytest.approx(where, rel=CLOSE)


def test_friction_with_a_wave_of_so_much_stops_a_block_where_the_energy_is_used_up():
    cosine, sine, number = 0.3 * SLIP, 0.2 * SLIP, 5.0
    run = block(SurfaceWave(clutch=0, cosine=cosine, sine=sine, number=number))

    def work(x):
        wave = cosine * sin(number * x) + sine * (1.0 - cos(number * x))
        return SLIP * x + wave / number

    where = brentq(lambda x: work(x) - 0.5 * MASS * SPEED**2, 0.0, 2.0, xtol=1e-14)
    assert run.end[0] == pytest.approx(where, rel=CLOSE)


def test_breakaway_grows_with_the_logarithm_of_the_dwell():
    rise, onset, slope = 0.1, 0.2, 0.7
    effect = DwellBreakaway(clutch=0, rise=rise, onset=onset)
    run = block(effect, 0.0, (Ramp(0.0, ((0.0, 0.0), (9.0, 9.0 * slope))),), t_end=6.0)
    when = brentq(
        lambda t: BREAK * (1 + rise * log(1 + t / onset)) - slope * t, 1.0, 9.0, xtol=1e-14
    )
    assert breakaway_of(run) == pytest.approx(when, rel=CLOSE)


@pytest.mark.parametrize("reference", [0.0, 2.0])
@pytest.mark.parametrize("slope", [0.5, 5.0])
def test_breakaway_falls_with_the_logarithm_of_the_ramps_slope(slope, reference):
    effect = RateBreakaway(clutch=0, fall=0.1, scale=0.3, filter=0.01, reference=reference)
    end = 1.2 * BREAK / slope
    run = block(effect, 0.0, (Ramp(0.0, ((0.0, 0.0), (end, end * slope))),), t_end=end)
    # Filters have settled: exp(-20) of the start is left at the steepest ramp.
    measured = BREAK * (1.0 + 0.1 * log(1.0 + reference / 0.3))
    level = measured / (1.0 + 0.1 * log(1.0 + slope / 0.3))
    assert breakaway_of(run) * slope == pytest.approx(level, rel=1e-7)


#: A mass that no friction slows: constant speed, and what friction takes is what the map says.
HEAVY, PACE = 1e12, 3.0


def lost(effect, t_end=4.0):
    return block(effect, speed=PACE, t_end=t_end, mass=HEAVY).end[-1]


def test_friction_that_fades_with_heat_loses_what_the_integral_says():
    fade, energy = 0.5, 10.0
    heat = lost(ThermalFade(clutch=0, fade=fade, energy=energy, cooling=1e15))
    # heat + fade heat^2/(2 energy) is the work that constant friction would have done.
    assert heat + fade * heat**2 / (2.0 * energy) == pytest.approx(SLIP * PACE * 4.0, rel=CLOSE)


def test_heat_settles_where_cooling_takes_what_friction_gives():
    fade, energy, cooling = 0.5, 10.0, 0.2
    run = block(
        ThermalFade(clutch=0, fade=fade, energy=energy, cooling=cooling),
        PACE,
        mass=HEAVY,
        t_end=8.0,
    )
    b = energy / fade
    heat = 0.5 * b * (sqrt(1.0 + 4.0 * SLIP * PACE * cooling / b) - 1.0)
    assert run.end[3] == pytest.approx(heat, rel=CLOSE)


def test_friction_that_warms_up_loses_what_the_integral_says():
    change, energy = 0.4, 8.0
    work = lost(WarmUp(clutch=0, change=change, energy=energy))
    steady = energy * log((exp(work / energy) + change) / (1.0 + change))
    assert steady == pytest.approx(SLIP * PACE * 4.0, rel=CLOSE)


def test_friction_that_wears_in_loses_what_the_integral_says():
    change, scale, distance = 0.3, 5.0, PACE * 4.0
    work = SLIP * (distance * (1 + change) - change * scale * (1.0 - exp(-distance / scale)))
    assert lost(WearIn(clutch=0, change=change, scale=scale)) == pytest.approx(work, rel=CLOSE)


def test_drifting_friction_loses_what_the_integral_says():
    work = SLIP * PACE * (4.0 + 0.05 * 4.0**2 / 2.0)
    assert lost(Drift(clutch=0, rate_per_time=0.05)) == pytest.approx(work, rel=CLOSE)


def test_friction_that_settles_loses_what_the_integral_says():
    amount, constant, lasts = 0.3, 1.5, 4.0
    work = PACE * (SLIP * lasts + amount * constant * (1.0 - exp(-lasts / constant)))
    effect = Settling(clutch=0, amount=amount, constant=constant)
    assert lost(effect) == pytest.approx(work, rel=CLOSE)


def test_friction_that_falls_with_temperature_loses_what_the_integral_says():
    # A curve that is level at both ends has its mean halfway: 30 degrees above the reference.
    points = ((0.0, 303.0), (4.0, 343.0))
    effect = FrictionByTemperature(clutch=0, change=-0.01, reference=293.0, points=points)
    assert lost(effect) == pytest.approx(SLIP * PACE * 4.0 * 0.7, rel=CLOSE)


def test_a_dahl_spring_brakes_by_its_closed_form():
    displacement = 0.05
    run = block(Dahl(clutch=0, displacement=displacement), t_end=0.5)
    x, v = run.end[0], run.end[1]
    work = SLIP * (x - displacement * (1.0 - exp(-x / displacement)))
    assert 0.5 * MASS * (SPEED**2 - v**2) == pytest.approx(work, rel=CLOSE)


def test_lugre_without_damping_and_peak_is_dahl():
    one = block(LuGre(clutch=0, displacement=0.02), brk=SLIP, t_end=1.0)
    other = block(Dahl(clutch=0, displacement=0.02), brk=SLIP, t_end=1.0)
    assert one.end[0] == pytest.approx(other.end[0], rel=CLOSE)


#: Presliding over its displacement, damped in proportion to it where it can be.
PRESLIDING = {
    "Dahl": lambda d: Dahl(clutch=0, displacement=d),
    "LuGre": lambda d: LuGre(clutch=0, displacement=d, damping=d),
    "ResetIntegrator": lambda d: ResetIntegrator(clutch=0, displacement=d, damping=d),
    "Bristles": lambda d: Bristles(clutch=0, displacement=d),
}


@pytest.mark.parametrize("model", PRESLIDING)
def test_presliding_tends_to_exact_stiction_in_proportion_to_its_displacement(model):
    """A mass on a spring comes to rest where exact stiction leaves it, but for a little give."""
    options = {"stiffness": 4.0, "t_end": 2.0}
    exact = block(Drift(clutch=0), **options).end[0]
    errors = []
    for d in (1e-3, 2.5e-4):
        run = block(PRESLIDING[model](d), **options)
        # The mean over the ringing of bristles that are damped little or not at all.
        late = [run.state(t, "left")[0] for t in np.linspace(1.0, 2.0, 400)]
        errors.append(abs(np.mean(late) - exact))
    # First order, and a displacement of 1e-3 is still some way from the limit of 4.
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.2)


@pytest.mark.parametrize(
    ("model", "give"),
    [
        # z/1.3 = 1 - exp(-x/(1.3 d)) with LuGre's g of breakaway over slip at rest; z = 0.8.
        (lambda d: LuGre(clutch=0, displacement=d, damping=10.0 * d), -1.3 * log(1 - 0.8 / 1.3)),
        (lambda d: ResetIntegrator(clutch=0, displacement=d, damping=d), 1.6 / BREAK),
        # The first of three has yielded: 1 + 1.5 s + s = 3 times 0.8.
        (lambda d: Bristles(clutch=0, displacement=d), 0.56),
    ],
    ids=["LuGre", "ResetIntegrator", "Bristles"],
)
def test_a_load_that_exact_stiction_holds_moves_it_by_a_share_of_its_displacement(model, give):
    assert BREAK / SLIP == 1.3
    load = Ramp(0.0, ((0.0, 0.0), (1.0, 1.6), (9.0, 1.6)))
    for d in (1e-3, 5e-4):
        moved = block(model(d), 0.0, (load,), t_end=1.05, mass=0.01).end[0]
        # What a mass of 10 g rings and creeps is some thousandths of it.
        assert moved / d == pytest.approx(give, rel=0.01)


def test_a_quarter_period_of_a_dahl_spring_alone():
    """Small displacements see a spring of stiffness force over displacement."""
    displacement, speed = 0.05, 1e-6
    run = block(Dahl(clutch=0, displacement=displacement), speed, t_end=0.05)
    rate = sqrt(SLIP / displacement / MASS)
    # The spring softens by about displacement travelled over displacement: 1e-6 here.
    assert run.end[0] == pytest.approx(speed / rate * sin(rate * 0.05), rel=1e-5)
    assert rate * 0.05 < pi


@pytest.mark.parametrize("model", [ResetIntegrator, Bristles], ids=lambda c: c.__name__)
def test_a_wound_spring_yields_at_its_displacement_and_takes_the_energy_of_its_triangle(model):
    displacement = 0.05
    run = block(model(clutch=0, displacement=displacement), brk=SLIP, t_end=0.5)
    x, v = run.end[0], run.end[1]
    # A triangle up to each yield, then the constant share.
    yields = (1 / 3, 2 / 3, 1.0) if model is Bristles else (1.0,)
    work = sum(SLIP / len(yields) * (x - 0.5 * y * displacement) for y in yields)
    assert x > displacement
    assert 0.5 * MASS * (SPEED**2 - v**2) == pytest.approx(work, rel=CLOSE)
