"""What presses a clutch, by a power or on another scale: it brakes as if pressed by so much."""

import pytest
from devices_for_tests import Block

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.effects.excitation_power import ExcitationPower
from simpter_hybrid.effects.excitation_scale import ExcitationScale
from simpter_hybrid.engine import simulate
from simpter_hybrid.laws.axis_friction import CoulombViscous
from simpter_hybrid.scenario import Scenario

#: Mass [kg], friction of each volt [N/V], speed at the start [m/s].
MASS, SLIP, SPEED = 1.5, 2.0, 1.2


@pytest.mark.parametrize(
    "effect",
    [
        ExcitationPower(clutch=0, change=-1 / 3, reference=2.0),  # eight times the reference
        ExcitationScale(clutch=0, gain=-0.25, offset=-4.0),
    ],
)
def test_what_presses_by_a_power_or_another_scale_brakes_so(effect):
    law = CoulombViscous(coulomb=0.0, normal=SLIP)
    clutch = Clutch(law, time_constant=0.0, threshold=-1.0)
    run = simulate(
        Scenario(
            "block", Block(MASS), (clutch,), (0.0,), (SPEED,), 5.0,
            command=(16.0,), excitation=(16.0,), effects=(effect,),
        )
    )  # fmt: skip
    stop = next(e.t for e in run.events if e.kind == "slip stop")
    # Sixteen volts that act as eight: the force is halved.  Solver tolerance 1e-10 a step.
    assert stop == pytest.approx(MASS * SPEED / (SLIP * 16.0 / 2.0), rel=1e-8)
