"""A clutch on a spring is let go while it slides and applied again: the energy it takes then."""

import pytest

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.profile import CommandProfile
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.effects.bristles import Bristles
from simpter_hybrid.effects.reset_integrator import ResetIntegrator
from simpter_hybrid.engine import simulate
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.scenario import Scenario

MASS, FORCE, DISPLACEMENT = 1.0, 10.0, 0.05


@pytest.mark.parametrize(
    ("model", "yields"), [(ResetIntegrator, (1.0,)), (Bristles, (1 / 3, 2 / 3, 1.0))]
)
def test_an_applied_clutch_takes_the_triangle_of_its_spring_again(model, yields):
    on = 0.8
    command = CommandProfile(((0.0, 10.0), (0.3, 10.0), (0.3, 0.0), (on, 0.0), (on, 10.0)))
    run = simulate(
        Scenario(
            "again", LinearAxis(MASS), (Clutch(LinearTorque(FORCE), time_constant=0.0, delay=0.0),),
            (0.0,), (10.0,), 1.2, controllers=((command, 1),), period=0.1,
            effects=(model(clutch=0, displacement=DISPLACEMENT),), rtol=1e-10, atol=1e-12,
        )
    )  # fmt: skip
    before = run.state(on, "left")
    slid = run.end[0] - before[0]
    work = sum(FORCE / len(yields) * (slid - 0.5 * y * DISPLACEMENT) for y in yields)
    # Solver tolerance; of the winding exp(-50) is left after the half second.
    assert 0.5 * MASS * (before[1] ** 2 - run.end[1] ** 2) == pytest.approx(work, rel=1e-8)
