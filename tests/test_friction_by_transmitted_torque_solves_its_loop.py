"""Friction that depends on the transmitted torque, which depends on the acceleration, and so on."""

import numpy as np
import pytest
from axis_recordings import MODEL
from devices_for_tests import Ramp, Waves, always_on

from simpter_hybrid.assembly.model import WiringError
from simpter_hybrid.checks.validation import validate
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.devices.two_link import TwoLink
from simpter_hybrid.effects.asymmetry import Asymmetry
from simpter_hybrid.effects.load_dependent import LoadDependent
from simpter_hybrid.effects.rotor_load import RotorLoad
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario

MASS, SLIP, BREAK, RISE, ROTOR = 1.5, 2.0, 2.4, 0.3, 0.9


def run_of(effect):
    waves = Waves(((0, 3.4, 3.0, 0.2), (0, 0.8, 11.0, 1.0)))
    run = Scenario("loaded", Testbed(MASS), (always_on(SLIP, BREAK),), (0.0,), (0.4,), 3.0)
    return simulate(
        run.replace(loads=(waves,), effects=(effect,), command=(1.0,), excitation=(1.0,))
    )


@pytest.mark.parametrize("rotor", [0.0, ROTOR])
def test_friction_equals_what_the_acceleration_it_causes_asks_for(rotor):
    run = run_of(RotorLoad(clutch=0, rise=RISE, rotor=rotor))
    seen = sample(run, np.linspace(0.0, 3.0, 500))
    slipping = seen.mode[:, 0] != 0
    through = seen.load[:, 0] - rotor * seen.qdd[:, 0]
    # Exact but for rounding.
    expected = SLIP + RISE * abs(through)
    assert abs(seen.tau[:, 0])[slipping] == pytest.approx(expected[slipping], rel=1e-13)
    stuck = ~slipping
    assert 20 < stuck.sum() < 480
    bound = BREAK + RISE * abs(seen.load[:, 0])
    assert (abs(seen.tau[stuck, 0]) <= bound[stuck] * (1.0 + 1e-12)).all()
    assert energy_balance(run, seen).relative < 1e-8


def test_without_a_rotor_both_forms_are_the_same():
    one, other = run_of(LoadDependent(clutch=0, rise=RISE)), run_of(RotorLoad(clutch=0, rise=RISE))
    # Two orders of the same operations.
    assert one.end[:2] == pytest.approx(other.end[:2], rel=1e-9)


def test_a_ramp_breaks_away_later_by_the_load_dependent_share():
    run = Scenario("ramp", Testbed(MASS), (always_on(SLIP, BREAK),), (0.0,), (0.0,), 5.0)
    load = Ramp(0.0, ((0.0, 0.0), (5.0, 5.0)))
    effect = LoadDependent(clutch=0, rise=RISE)
    found = simulate(
        run.replace(loads=(load,), effects=(effect,), command=(1.0,), excitation=(1.0,))
    )
    when = next(e.t for e in found.events if e.kind == "breakaway")
    assert when == pytest.approx(BREAK / (1.0 - RISE), rel=1e-12)


def test_a_bearing_rubs_more_by_what_hangs_on_it_whatever_drives():
    weight, coulomb = 0.5, 0.2
    hanging = parse(MODEL).replace(
        q=(0.5 * np.pi,), controllers=(), t_end=5.0,
        loads=(Ramp(0.0, ((0.0, weight), (5.0, weight + 1.0))),),
        effects=(LoadDependent(clutch=0, rise=RISE, external=1.0, driven=0.0),),
    )  # fmt: skip
    when = next(e.t for e in simulate(hanging).events if e.kind == "breakaway")
    assert when == pytest.approx(5.0 * (coulomb + RISE * weight), rel=1e-12)


def test_several_surfaces_each_feel_what_goes_through_themselves():
    arm = TwoLink(0.5, 0.6, 0.2, 0.2, 0.25, 0.03, 0.05, gravity=0.0)
    rises = (0.3, 0.2)
    waves = Waves(((0, 3.4, 3.0, 0.2), (0, 0.8, 11.0, 1.0), (1, 3.0, 4.0, 1.5)))
    run = Scenario(
        "arm", arm, (always_on(SLIP, BREAK),) * 2, (0.3, 0.9), (0.4, -0.5), 3.0, loads=(waves,),
        effects=tuple(LoadDependent(clutch=i, rise=rises[i]) for i in (0, 1)),
        command=(1.0, 1.0), excitation=(1.0, 1.0),
    )  # fmt: skip
    run = simulate(run)
    seen = sample(run, np.linspace(0.0, 3.0, 500))
    for i in (0, 1):
        slipping = seen.mode[:, i] != 0
        assert 20 < slipping.sum() < 480
        expected = SLIP + rises[i] * abs(seen.load[:, i])
        assert abs(seen.tau[:, i])[slipping] == pytest.approx(expected[slipping], rel=1e-13)
        bound = BREAK + rises[i] * abs(seen.load[:, i])
        assert (abs(seen.tau[:, i])[~slipping] <= bound[~slipping] * (1.0 + 1e-12)).all()
    assert energy_balance(run, seen).relative < 1e-8


def test_the_loop_is_refused_where_it_is_not_solved():
    arm = TwoLink(0.5, 0.6, 0.2, 0.2, 0.25, 0.03, 0.05, gravity=0.0)
    run = Scenario("arm", arm, (always_on(SLIP, BREAK),) * 2, (0.3, 0.9), (0.4, -0.5), 3.0)
    run = run.replace(effects=(RotorLoad(clutch=0, rise=RISE, rotor=ROTOR),))
    with pytest.raises(WiringError, match="only a device of one coordinate and one clutch"):
        simulate(run.replace(command=(1.0, 1.0), excitation=(1.0, 1.0)))


def test_the_loop_is_refused_where_another_effect_comes_after_it():
    run = Scenario("loaded", Testbed(MASS), (always_on(SLIP, BREAK),), (0.0,), (0.4,), 3.0)
    effects = (RotorLoad(clutch=0, rise=RISE, rotor=ROTOR), Asymmetry(clutch=0, share=0.1))
    with pytest.raises(WiringError, match=r"must be the last .* Asymmetry comes after it"):
        simulate(run.replace(effects=effects))
    # The other way round the loop is solved for all of the friction.
    run = run.replace(effects=effects[::-1], loads=(Waves(((0, 3.4, 3.0, 0.2),)),))
    seen = sample(simulate(run.replace(command=(1.0,), excitation=(1.0,))), np.linspace(0, 1, 90))
    slips = seen.mode[:, 0] != 0
    expected = SLIP * (1.0 + 0.1 * seen.mode) + RISE * abs(seen.load - ROTOR * seen.qdd)
    assert abs(seen.tau)[slips] == pytest.approx(expected[slips], rel=1e-13)


def test_a_rotor_heavier_than_all_that_moves_is_refused():
    run = Scenario("loaded", Testbed(MASS), (always_on(SLIP, BREAK),), (0.0,), (0.4,), 3.0)
    run = run.replace(effects=(RotorLoad(clutch=0, rise=0.9, rotor=1.2 * MASS),))
    with pytest.raises(InvalidInput, match=r"effects\.0\.rotor: more than the whole"):
        validate(run)
    # Not checked beforehand, it ends as a failure and never as a result.
    assert simulate(run.replace(command=(1.0,), excitation=(1.0,))).status == "failed"
