"""Backlash before a clutch: nothing in the play, a spring at its ends, breakaway, then sliding."""

import numpy as np
import pytest
from devices_for_tests import Block, Waves, always_on

from simpter_hybrid.effects.clutch_backlash import ClutchBacklash
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario

SLIP, BREAK, HEAVY, PACE = 2.0, 2.6, 1e12, 0.3
GAP, STIFFNESS = 0.02, 200.0


def moved(effect, t_end, speed=PACE, loads=(), start=0.0):
    """A mass that nothing slows drives a clutch through a play."""
    run = Scenario("moved", Block(HEAVY, 0.0), (always_on(SLIP, BREAK),), (start,), (speed,), t_end)
    told = {"effects": (effect,), "command": (1.0,), "excitation": (1.0,), "loads": loads}
    return simulate(run.replace(**told))


def test_nothing_is_lost_within_the_play():
    play = ClutchBacklash(clutch=0, gap=GAP, stiffness=STIFFNESS)
    assert moved(play, 0.49 * GAP / PACE).end[-1] == 0.0


def test_beyond_it_a_spring_is_wound_up_to_breakaway_and_friction_slides_from_there():
    way, torn = 0.2, 0.5 * GAP + BREAK / STIFFNESS
    run = moved(ClutchBacklash(clutch=0, gap=GAP, stiffness=STIFFNESS), way / PACE)
    work = 0.5 * BREAK**2 / STIFFNESS + SLIP * (way - torn)
    assert run.end[-1] == pytest.approx(work, rel=1e-8)
    slides = sample(run, np.array([torn / PACE - 1e-9, torn / PACE + 1e-9]))
    assert slides.tau[:, 0] == pytest.approx([-BREAK, -SLIP], rel=1e-6)


def test_after_a_reversal_the_spring_unwinds_and_the_play_is_crossed():
    amplitude = 0.1
    shaken = Waves(((0.0, HEAVY * amplitude * 100.0, 10.0, 0.5 * np.pi),))
    play = ClutchBacklash(clutch=0, gap=GAP, stiffness=STIFFNESS, relaxation=1e-4)
    run = moved(play, 0.628, 0.0, (shaken,), -amplitude)
    turned = np.linspace(0.1 * np.pi + 1e-3, 0.62, 4000)
    seen = sample(run, turned)
    torque, way = seen.tau[:, 0], amplitude - seen.q[:, 0]
    wound = SLIP / STIFFNESS
    within = (way > wound + 1e-6) & (way < wound + GAP - 1e-6)
    assert within.sum() > 50
    assert (torque[within] == 0.0).all()
    # Winding beyond the slip torque at the reversal: acceleration times relaxation squared, 1e-7.
    unwinding = way < wound - 1e-6
    expected = -(SLIP - STIFFNESS * way[unwinding])
    assert torque[unwinding] == pytest.approx(expected, abs=1e-4)


def test_a_contact_may_lose_energy_and_never_pulls():
    stiff = ClutchBacklash(clutch=0, gap=GAP, stiffness=STIFFNESS, damping=0.01)
    run = Scenario("thrown", Block(1.0, 0.0), (always_on(SLIP, BREAK),), (0.0,), (0.02,), 2.0)
    told = {"effects": (stiff,), "command": (1.0,), "excitation": (1.0,)}
    run = simulate(run.replace(**told))
    seen = sample(run, np.linspace(0.0, 2.0, 2000))
    torque = seen.tau[:, 0]
    assert torque.min() < -0.1  # it was struck: friction is against the motion
    assert (torque * np.sign(seen.q[:, 0]) <= 0.0).all()
    assert abs(run.end[1]) < 0.02
