"""A dead time of all clutches' commands: two routes to one prediction."""

from dataclasses import replace

import numpy as np
import pytest
import robot_replays as robot

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.tip.rig import TipRig


def commanded_at(rows: int) -> Replay:
    """The robot's short run, with its commands from that row on."""
    run = robot.replay()
    off = {n: np.where(np.arange(v.size) < rows, 0.0, v) for n, v in run.inputs.items()}
    return replace(run, inputs={n: off[n] if "command" in n else v for n, v in run.inputs.items()})


def test_commands_of_a_robot_that_come_late_are_those_of_before() -> None:
    declared, candidate = robot.declared(), robot.candidates()["command-delay"]
    samples = 3
    late = samples * declared.period
    rows = round(late / (robot.TIME[1] - robot.TIME[0]))
    predictor = ScenarioPredictor(declared, TipRig()).extended(candidate)
    values = {p.name: p.value for p in predictor.parameters} | {"command-delay.delay": late}
    told = predictor.predict(values, [commanded_at(1)])["position_1"][0]
    plain = ScenarioPredictor(declared, TipRig())
    there = plain.predict(values, [commanded_at(1 + rows)])["position_1"][0]
    # Replays are integrated to 1e-7.
    assert told == pytest.approx(there, abs=1e-7)
    assert np.abs(told - plain.predict(values, [commanded_at(1)])["position_1"][0]).max() > 1e-5


def test_the_corrected_model_has_a_stage_for_each_clutch() -> None:
    candidate = robot.candidates()["command-delay"]
    made = candidate.made_stages({"command-delay.delay": 0.015})
    assert [(stage.clutch, stage.delay) for stage, _ in made] == [(k, 0.015) for k in range(4)]
