"""A point mass at the tip: PTER's own three inertias take it up, any arm keeps its energy."""

from dataclasses import replace

import pytest
from devices_for_tests import Block, Waves, always_on

from simpter_hybrid import compiled, engine
from simpter_hybrid.assembly.model import WiringError
from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.files.scenario_file import load, parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.loads.tip_mass import TipMass
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario

MASS = 3.0
WAVES = Waves(((0, 60.0, 9.0, 0.0), (1, 40.0, 13.0, 1.0)))


def _pter(device, *loads):
    """Two clutches that slip and stick in turn."""
    clutches = tuple(always_on(*pair) for pair in ((9, 12), (7, 9), (2, 3), (4, 5)))
    run = Scenario("mass", device, clutches, (1.2, 2.0), (0.4, -0.5), 1.5, loads=(WAVES, *loads))
    return run.replace(command=(1.0,) * 4, excitation=(1.0,) * 4)


@pytest.mark.parametrize(
    "simulate", [engine.simulate, compiled.simulate], ids=["exact", "compiled"]
)
def test_pter_takes_a_mass_at_its_tip_up_in_three_inertias(simulate):
    pter = Pter(33.0, 10.0, -1.3, 0.9, 0.6)
    a, d = pter.l_a, pter.l_d
    heavier = replace(
        pter, alpha=pter.alpha + 0.5 * MASS * a * a, beta=pter.beta + 0.5 * MASS * d * d,
        gamma=pter.gamma - MASS * a * d,
    )  # fmt: skip
    one, other = simulate(_pter(heavier)), simulate(_pter(pter, TipMass(MASS)))
    assert [(e.kind, e.clutches) for e in one.events] == [
        (e.kind, e.clutches) for e in other.events
    ]
    assert len(one.events) > 4
    # Both solve the same equations, written otherwise, to a relative tolerance of 1e-10.
    assert other.end == pytest.approx(one.end, rel=1e-7, abs=1e-9)


def test_an_arm_of_three_links_keeps_its_energy_with_a_mass_at_the_tip():
    clutches = tuple(
        always_on(*pair) for pair in ((0.5, 0.6), (0.2, 0.3), (0.1, 0.2), (1, 2), (1, 2))
    )
    run = Scenario(
        "arm", PlanarArm(), clutches, (0.3, 0.9, 1.6), (1.0, -2.0, 3.0), 0.6,
        loads=(Waves(((0, 8.0, 20.0, 0.0), (1, 6.0, 13.0, 1.0))), TipMass(MASS)),
    ).replace(command=(1.0,) * 5, excitation=(1.0,) * 5)  # fmt: skip
    found = engine.simulate(run)
    # Velocity terms that did not belong to the mass matrix would make or take energy.
    assert energy_balance(found).relative < 1e-8
    start, bare = (sample(each, [0.0]) for each in (found, engine.simulate(run.replace(loads=()))))
    speed = start.tip_velocity[0]
    assert start.kinetic[0] - bare.kinetic[0] == pytest.approx(
        0.5 * MASS * speed @ speed, rel=1e-12
    )


def test_a_file_says_it_as_it_is_written():
    made = load(find_model("robot")).replace(loads=(TipMass(MASS),))
    text = resolve(made).text
    assert 'kind = "tip-mass"' in text
    assert parse(text).loads == made.loads


def test_a_device_without_a_tip_is_refused():
    run = Scenario("block", Block(), (always_on(1, 1),), (0.0,), (0.0,), 1.0, loads=(TipMass(1.0),))
    with pytest.raises(WiringError, match="no tip_jacobian"):
        engine.simulate(run)
