"""Friction that depends on the transmitted torque, which depends on the acceleration, and so on."""

import numpy as np
import pytest
from devices_for_tests import Waves, always_on

from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.devices.two_link import TwoLink
from simpter_hybrid.effects.load_dependent import LoadDependent
from simpter_hybrid.effects.rotor_load import RotorLoad
from simpter_hybrid.energy import energy_balance
from simpter_hybrid.engine import simulate
from simpter_hybrid.model import WiringError
from simpter_hybrid.sampling import sample
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
    from devices_for_tests import Ramp

    run = Scenario("ramp", Testbed(MASS), (always_on(SLIP, BREAK),), (0.0,), (0.0,), 5.0)
    load = Ramp(0.0, ((0.0, 0.0), (5.0, 5.0)))
    effect = LoadDependent(clutch=0, rise=RISE)
    found = simulate(
        run.replace(loads=(load,), effects=(effect,), command=(1.0,), excitation=(1.0,))
    )
    when = next(e.t for e in found.events if e.kind == "breakaway")
    assert when == pytest.approx(BREAK / (1.0 - RISE), rel=1e-12)


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
    with pytest.raises(WiringError, match="one coordinate with one clutch has it"):
        simulate(run.replace(command=(1.0, 1.0), excitation=(1.0, 1.0)))
