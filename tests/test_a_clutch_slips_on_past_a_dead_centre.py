"""A slider on a crank: at a dead centre its row of the clutch map is zero, and it cannot hold."""

import math
from dataclasses import dataclass
from typing import ClassVar

import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import simpter_hybrid as simpter
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.device import Device
from simpter_hybrid.effects.thermal_fade import ThermalFade
from simpter_hybrid.laws import CoulombViscous
from simpter_hybrid.part import parameter
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario

INERTIA, MASS, RADIUS, START, SPEED = 0.02, 0.5, 0.1, 0.5, 10.0


@dataclass(frozen=True)
class Yoke(Device):
    """A crank with a brake drives a slider that rubs: ``x = radius (1 - cos q)``."""

    inertia: float = parameter("inertia", INERTIA)
    mass: float = parameter("mass", MASS)
    radius: float = parameter("length", RADIUS)
    coordinates: ClassVar[tuple[str, ...]] = ("crank",)
    surfaces: ClassVar[tuple[str, ...]] = ("brake", "slider")
    constant_clutch_map: ClassVar[bool] = False

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0] + p[1] * (p[2] * math.sin(q[0])) ** 2

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = p[1] * p[2] ** 2 * math.sin(q[0]) * math.cos(q[0]) * qd[0] ** 2

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = p[2] * math.sin(q[0])

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0
        out[1] = p[2] * math.cos(q[0]) * qd[0] ** 2


def scenario(q, qd):
    clutches = [Clutch(CoulombViscous(coulomb=c), 0.0, 0.0, threshold=-1.0) for c in (0.0, 1.0)]
    return Scenario("yoke", Yoke(), tuple(clutches), (q,), (qd,), 1.0)


def angle_after(q, qd, duration):
    """By energy: friction takes force times way; the time is a quadrature of the speed."""

    def way(x):
        return 2 * (x // math.pi) + 1 - math.cos(x % math.pi)

    def inertia(x):
        return INERTIA + MASS * (RADIUS * math.sin(x)) ** 2

    def slowness(x):
        energy = inertia(q) * qd**2 / 2 - RADIUS * (way(x) - way(q))
        return math.sqrt(inertia(x) / (2 * energy))

    def late(x):
        dead = [math.pi * k for k in range(1, 5) if q < math.pi * k < x]
        return quad(slowness, q, x, points=dead or None, epsabs=1e-12)[0] - duration

    return brentq(late, q + 1.0, 12.0, xtol=1e-12)


@pytest.mark.parametrize("q", [START, 0.0, math.pi])
@pytest.mark.parametrize("engine", ["reference", "compiled"])
def test_a_clutch_slips_on_past_a_dead_centre(engine, q):
    if engine == "compiled":
        pytest.importorskip("llvmlite")
    run = simpter.run(scenario(q, SPEED), engine=engine)
    # Tolerance 1e-10 of the solver, over some dozen steps.
    assert run.end[0] == pytest.approx(angle_after(q, SPEED, 1.0), abs=1e-8)


def test_an_effect_that_does_nothing_changes_nothing_of_a_start_at_a_dead_centre():
    nothing = ThermalFade(clutch=1, fade=0.0)
    alone, beside = (scenario(math.pi, SPEED).replace(effects=e) for e in ((), (nothing,)))
    assert simpter.run(beside).end[0] == pytest.approx(simpter.run(alone).end[0], abs=1e-8)


def test_a_start_at_rest_at_a_dead_centre_is_refused():
    with pytest.raises(InvalidInput, match="clutch 2 is at its dead centre"):
        simpter.run(scenario(0.0, 0.0))
