"""The inertia of a prescribed motion leaves the force on what sticks to it its digits."""

import math

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq

import simpter_hybrid as simpter
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.shaft_pair import ShaftPair
from simpter_hybrid.effects.prescribed_motion import PrescribedMotion
from simpter_hybrid.interpolation import parabolic_slopes
from simpter_hybrid.laws import CoulombViscous
from simpter_hybrid.scenario import Scenario

DRIVEN, LIMIT = 1.0, 2.0


@pytest.mark.parametrize("engine", ["reference", "compiled"])
def test_what_is_stuck_on_a_prescribed_motion_breaks_away_in_time(engine):
    if engine == "compiled":
        pytest.importorskip("llvmlite")
    instants = [0.05 * k for k in range(7)]
    places = [0.1 * math.sin(6.0 * t) for t in instants]
    course = CubicHermiteSpline(instants, places, parabolic_slopes(instants, places))
    clutches = [Clutch(CoulombViscous(coulomb=c), 0.0, 0.0, threshold=-1.0) for c in (LIMIT, 0.0)]
    moved = PrescribedMotion(coordinate=0, points=tuple(zip(instants, places, strict=True)))
    speed = float(course(0.0, 1))
    scenario = Scenario(
        "carried", ShaftPair(1.0, DRIVEN), tuple(clutches), (0.0, 0.0), (speed, speed), 0.1,
        effects=(moved,),
    )  # fmt: skip
    run = simpter.run(scenario, engine=engine)
    first = next(event.t for event in run.events if event.kind == "breakaway")
    # Within the second piece the acceleration is a straight line.
    inner = np.nextafter(instants[1:3], instants[2:0:-1])
    due = brentq(lambda t: DRIVEN * abs(course(t, 2)) - LIMIT, *inner)
    # The force that moves the large inertia, 2e9 N, is rounded to 2e-7 N; what the clutch has to
    # hold grows by 58 N a second: 4e-9 s for one rounding, with room for a few of them.
    assert first == pytest.approx(due, abs=2e-8)
