"""A sensor zeroed anew before each run: a place of rest differs by amounts of either sign."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import LET_ALONE, declared_axis, written
from scipy.integrate import solve_ivp
from toy_rig import ALONG_X, SCALE, ToyRig, toy_replay

from simpter_hybrid.effects.spring_force import SpringForce
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.own_values import run_levels
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.reporting.level_sentences import levels_text
from simpter_hybrid.identification.rigs.tolerated import tolerated
from simpter_hybrid.identification.rigs.zeros import OF_POSITION, zero_of_position
from simpter_hybrid.identification.run_levels import differs

#: What runs have beside a median of none.
OFFSETS = (0.2, -0.3, 0.0, 0.4, -0.1)
ZERO = replace(ALONG_X.parameters[0], unit="rad", signed=True)
#: A bob on a spring: natural frequency [rad/s], friction over inertia [rad/s^2], step of rows [s].
OWN, DRY, ROW = 6.0, 0.4, 0.01
MODEL = """
[run]
t_end = "5 s"
[start]
coordinates = ["1 rad"]
[device]
kind = "one-axis"
inertia = "1e-3 kg*m^2"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "4e-4 N*m" }
[[effects]]
kind = "spring-force"
coordinate = "joint"
stiffness = "0.036 N*m/rad"
[[tolerances]]
name = "Coulomb friction"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.3
"""
ANGLE = '[channels.position]\ncolumn = "a"\nunit = "rad"\nsign = 1\nrole = "measured"\n'


def told(offsets, zero=ZERO):
    runs = [toy_replay(str(k), k, gain=x) for k, x in enumerate(offsets)]
    rig = ToyRig((SCALE, zero))
    model = refitted(rig, Split(runs, runs, runs), start={"scale": 1.0, "gain": 0.0})
    return run_levels(model, runs, 1.0, ("gain",))


def test_each_run_gets_an_amount_of_either_sign():
    found = told(OFFSETS)
    # Half a run's 1000 samples of 0.7 rms with noise 0.1 know it to 0.0045; three of them.
    assert list(found.values(ZERO).values()) == pytest.approx(OFFSETS, abs=0.014)
    assert found.own() == pytest.approx(OFFSETS, abs=0.028)  # from their median
    assert differs(found)
    text = levels_text((found,), 1.0)
    assert "rad from its median" in text
    assert "zeroed anew before each run" in text
    assert "bound" not in text


def test_the_same_zero_in_all_is_none_of_each_run():
    found = told((0.3,) * 5)
    assert np.ptp(found.own()) < 0.03
    assert found.share < 0.4


def test_a_value_that_ends_at_a_bound_is_told_so():
    near = replace(ZERO, lower=-0.1, upper=0.1)  # three times as far is tried
    found = told((0.2, -0.3, 0.0, 0.9, -0.1), near)
    assert found.ended == ("3",)
    assert "3 ends at the bound of what is tried" in levels_text((found,), 1.0)


def test_a_factor_that_ends_at_a_bound_is_told_so():
    runs = [toy_replay(str(k), k, scale=s, noise=1.0) for k, s in enumerate((1.0, 4.0, 1.1))]
    found = run_levels(refitted(ToyRig(), Split(runs, runs, runs)), runs, 1.0)
    assert found.ended == ("1",)


def test_a_tolerance_of_a_place_lets_it_change_its_sign():
    rest = tolerated({"name": "rest", "parameters": ["effect.1.SpringForce.rest"], "relative": 1.0})
    assert rest.signed
    assert rest.lower == -2.5
    friction = tolerated({"name": "f", "parameters": ["clutch.1.torque.coulomb"], "relative": 1.0})
    assert not friction.signed
    assert friction.lower == 0.05


def test_it_is_the_zero_of_all_places_that_are_declared_without_a_tolerance():
    hangs = declared_axis()
    both = replace(hangs, effects=(SpringForce(coordinate=0, stiffness=1.0),))
    zero = zero_of_position(both, 2.0, turning=True)
    assert [name for _, name, _ in zero.shifts] == ["effect.1.SpringForce.rest", "device.hanging"]
    known = {"name": "hangs", "parameters": ["device.hanging"], "relative": 0.1}
    notes = {**both.notes, "tolerances": (*both.notes["tolerances"], known)}
    assert zero_of_position(replace(both, notes=notes), 2.0, turning=True) is None
    nowhere = replace(hangs, device=replace(hangs.device, weight=0.0))
    assert zero_of_position(nowhere, 2.0, turning=True) is None


def said_of(recording):
    """A diagnosis with few of the library's effects, of some that do not explain it."""
    taken = as_recorded(recording)
    every = bench_of(taken, parse(MODEL), groups_of(taken)).candidates
    few = [c for c in every if c.name in ("viscous-drag", "bias-force", "quadratic-drag")]
    return diagnose(recording, parse(MODEL), few)


def swings(folder, zeros):
    """Takes of a bob let go on its spring, each read from a zero of its own."""
    generator, rows = np.random.default_rng(1), ["take,s,a"]
    for take, zero in enumerate(zeros):
        begun = 1.2 - 0.1 * take

        def rates(_, state):
            return [state[1], -(OWN**2) * state[0] - DRY * np.tanh(state[1] / 1e-3)]

        time = np.arange(0.0, 4.0, ROW)
        swung = solve_ivp(rates, (0.0, 4.0), [begun, 0.0], "LSODA", time, rtol=1e-7, atol=1e-9)
        seen = swung.y[0] + zero + generator.normal(0.0, 2e-3, time.size)
        rows += [f"{take},{t:.2f},{a:.5f}" for t, a in zip(time, seen, strict=True)]
    return written(folder, rows, LET_ALONE + ANGLE)


@pytest.mark.slow
def test_a_pendulum_whose_sensor_was_zeroed_anew_is_told_so(tmp_path):
    zeros = (0.05, -0.04, 0.02, -0.06, 0.0, 0.03)
    found = said_of(swings(tmp_path, zeros))
    assert found.search.verdict.kind == "unknown"
    assert [one.parameter for one in found.levels] == [OF_POSITION]
    by_run = dict(zip((f"take {k}" for k in range(6)), zeros, strict=True))
    expected = [by_run[run] for run, _ in found.levels[0].levels]
    # Half the windows of a take: 200 rows with noise 2 mrad, some of which tell next to nothing.
    own = np.array(found.levels[0].own())
    assert own - own.mean() == pytest.approx(np.array(expected) - np.mean(expected), abs=2e-3)


@pytest.mark.slow
def test_one_zero_for_all_lacks_nothing_of_that(tmp_path):
    assert said_of(swings(tmp_path, (0.0,) * 6)).search.verdict.kind == "nothing missing"
