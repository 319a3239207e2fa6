"""Stages that rewrite held inputs, behind ones that act less often: two rates to one course."""

from itertools import pairwise

import pytest

from simpter_hybrid import compiled, engine
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.blending import Blending
from simpter_hybrid.controllers.command_delay import CommandDelay
from simpter_hybrid.controllers.dead_time import DeadTime
from simpter_hybrid.controllers.desired_torque import DesiredTorque
from simpter_hybrid.controllers.integral_feedback import IntegralFeedback
from simpter_hybrid.controllers.lookup import LookupTable
from simpter_hybrid.controllers.profile import CommandProfile
from simpter_hybrid.controllers.torque_feedback import TorqueFeedback
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.scenario import Scenario

SAMPLE = 0.002
SELECTOR, TABLE = DesiredTorque(5.0), LookupTable(10.0)
STEP = CommandProfile(((0.0, 1.0), (0.02, 1.0), (0.02, 5.0), (1.0, 5.0)))
#: The stages that act less often, and those behind them that do not.
CHAINS = {
    "CommandDelay": ((STEP,), (CommandDelay(0.005),)),
    "Blending": ((SELECTOR,), (Blending(0.05, 0.05), TABLE)),
    "TorqueFeedback": ((SELECTOR, TABLE), (TorqueFeedback(0.2),)),
    "two": ((SELECTOR, TABLE), (TorqueFeedback(0.2), IntegralFeedback(3.0))),
}


def commands(simulate, slow, fine, every):
    return commands_of(simulate, (*((s, every) for s in slow), *((s, 1) for s in fine)))


def commands_of(simulate, controllers, t_end=0.1):
    run = simulate(
        Scenario(
            "rates", LinearAxis(1.0), (Clutch(LinearTorque(10.0), time_constant=0.01),),
            (0.0,), (50.0,), t_end, command=(1.0,), excitation=(1.0,), period=SAMPLE,
            controllers=controllers,
        )
    )  # fmt: skip
    return {
        round(float(t), 6): float(v)
        for t, v in zip(run.segment_t[:, 0], run.held[:, 0], strict=True)
    }


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
@pytest.mark.parametrize("chain", CHAINS)
def test_how_often_the_stages_before_it_repeat_themselves_makes_no_difference(chain, simulate):
    often, seldom = (commands(simulate, *CHAINS[chain], every) for every in (1, 5))
    assert len(set(often.values())) > 2
    assert often == seldom


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
@pytest.mark.parametrize(("source", "stage"), [(3, 2), (5, 2), (2, 3)])
def test_periods_of_which_neither_divides_the_other_bring_nothing_back(source, stage, simulate):
    controllers = (STEP, source), (CommandDelay(0.0), stage)
    found = list(commands_of(simulate, controllers).values())
    told = [b for a, b in pairwise(found) if a != b]
    assert told == [5.0]


def changes(points, delay):
    found = commands(engine.simulate, (CommandProfile(points),), (DeadTime(delay),), 5)
    values = list(found.items())
    return [(t, v) for (t, v), (_, last) in zip(values[1:], values, strict=False) if v != last]


def test_a_command_told_again_within_its_dead_time_does_not_wait_anew():
    # Told at 0.02 s and every 0.01 s after that, longer than which it waits.
    assert changes(((0.0, 0.0), (0.02, 0.0), (0.02, 5.0), (1.0, 5.0)), 0.016) == [(0.036, 5.0)]


def test_a_command_taken_back_within_its_dead_time_never_acts():
    points = ((0.0, 0.0), (0.02, 0.0), (0.02, 5.0), (0.03, 5.0), (0.03, 0.0), (1.0, 0.0))
    assert changes(points, 0.016) == []
    assert changes(points, 0.006) == [(0.026, 5.0), (0.036, 0.0)]
