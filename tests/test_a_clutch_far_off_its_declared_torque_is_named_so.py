"""A torque scale set free: two routes to one prediction, and what else does the same."""

from dataclasses import replace

import numpy as np
import pytest
import robot_replays as robot

from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.tip.candidates import tip_candidates
from simpter_hybrid.identification.tip.rig import TipRig
from simpter_hybrid.identification.tip.structure import Scales, structure_candidates
from simpter_hybrid.identification.tracing.rivals import rivals_of
from simpter_hybrid.laws.table_torque import TableTorque

SCALE = "torque-scale by clutch"
SCALES = Scales(20.0, 0.5, 0.5, 10.0)


def test_its_share_is_another_declared_scale():
    declared, candidate = robot.declared(), robot.candidates()[SCALE]
    second = declared.clutches[1]
    weak = replace(second, torque=replace(second.torque, scale=0.65 * second.torque.scale))
    clutches = (declared.clutches[0], weak, *declared.clutches[2:])
    predictor = ScenarioPredictor(declared, TipRig()).extended(candidate)
    values = {p.name: p.value for p in predictor.parameters}
    other = ScenarioPredictor(replace(declared, clutches=clutches), TipRig())
    run = [robot.replay()]
    found = predictor.predict(values | {f"{SCALE}.2.share": -0.35}, run)["position_1"][0]
    # Replays are integrated to 1e-7.
    assert found == pytest.approx(other.predict(values, run)["position_1"][0], abs=1e-7)
    assert np.abs(found - predictor.predict(values, run)["position_1"][0]).max() > 5e-5


def test_clutches_whose_torque_has_no_scale_have_no_such_candidate():
    declared = robot.declared()
    points = TableTorque(points=((0.0, 0.0, 0.0), (10.0, 60.0, 65.0)))
    plain = replace(declared.clutches[0], torque=points)
    other = replace(declared, clutches=(plain,) * 4)
    names = {c.name for c in structure_candidates(other, SCALES)}
    assert SCALE in robot.candidates()
    assert SCALE not in names


@pytest.mark.parametrize(
    ("rival", "stays"),
    [
        ("warm-up by clutch", False),
        ("stribeck by clutch", False),
        ("command-scale by clutch", True),
    ],
)
def test_what_comes_down_to_a_scale_at_a_limit_is_no_rival_of_one(rival, stays):
    device = tip_candidates(2, 4, (0.1, 0.1), 20.0, 1.0)
    known = {c.name: c for c in (*device, *structure_candidates(robot.declared(), SCALES))}
    best, other = (Trial(known[name], None, 1.0, 0.5, 1.0) for name in (SCALE, rival))
    assert bool(rivals_of(best, (best, other), 1.0)) is stays
