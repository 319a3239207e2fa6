"""Stages that serve desired torques, where a selector desires that of the first clutch alone."""

import pytest

from simpter_hybrid import compiled, engine
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.blending import Blending
from simpter_hybrid.controllers.desired_torque import DesiredTorque
from simpter_hybrid.controllers.integral_feedback import IntegralFeedback
from simpter_hybrid.controllers.inverse_model import InverseModel
from simpter_hybrid.controllers.lookup import LookupTable
from simpter_hybrid.controllers.piecewise_table import PiecewiseTable
from simpter_hybrid.controllers.servo import SpeedServo
from simpter_hybrid.controllers.torque_feedback import TorqueFeedback
from simpter_hybrid.devices.shaft_pair import ShaftPair
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.loads.motor import HeldTorque
from simpter_hybrid.scenario import Scenario

TABLE = LookupTable(10.0)
#: Stages behind a selector of clutch 1 and a servo, whose held torque follows the desired one.
CHAINS = {
    "table": (TABLE,),
    "pieces": (PiecewiseTable(((0.0, 0.0), (10.0, 10.0))),),
    "inverse": (InverseModel(),),
    "blending": (Blending(0.0, 0.0), TABLE),
    "feedback": (TABLE, TorqueFeedback(0.1)),
    "integral": (TABLE, IntegralFeedback(0.1)),
}


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
@pytest.mark.parametrize("chain", CHAINS)
def test_the_second_clutch_keeps_its_command(simulate, chain):
    stages = (DesiredTorque(0.5), SpeedServo(10.0, 1.0, 0.0, 4.0), *CHAINS[chain])
    run = simulate(
        Scenario(
            "pair", ShaftPair(0.1, 0.1), (Clutch(LinearTorque(10.0)),) * 2, (0.0, 0.0), (5.0, 5.0),
            0.1, (HeldTorque(),), tuple((s, 1) for s in stages), period=0.01, command=(0.0, 2.0),
        )
    )  # fmt: skip
    at = run.scenario.sizes()["m"]
    assert max(row[at + 1] for row in run.held) > 1.0  # the motor's torque
    assert {row[1] for row in run.held} == {2.0}
    assert max(row[0] for row in run.held) > 0.0
