"""A clutch lets go of a constant load as it weakens: by its excitation, or by a drift alone."""

import pytest
from devices_for_tests import Coulomb, Ramp

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.drift import Drift
from simpter_hybrid.engine import simulate
from simpter_hybrid.explanation.explain import explain
from simpter_hybrid.scenario import Scenario


@pytest.mark.parametrize(
    ("command", "effects", "cause"),
    [
        (
            1.0,
            (Drift(clutch=0, rate_per_time=-0.4),),
            "the clutch weakened, though its excitation did not fall",
        ),
        (0.5, (), "the clutch weakened (its excitation was falling)"),
    ],
)
def test_an_explanation_blames_an_excitation_only_if_it_fell(command, effects, cause):
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=1.0, full_scale=10.0)
    push = Ramp(0.0, ((0.0, 0.8), (2.0, 0.8)))
    run = simulate(
        Scenario("held", Testbed(1.0), (clutch,), (0.0,), (0.0,), 2.0, loads=(push,),
                 effects=effects, command=(command,), excitation=(1.0,))
    )  # fmt: skip
    event = next(e for e in run.events if e.kind == "breakaway")
    assert cause in " ".join(str(explain(run, event.t)).split())
