"""A two-link arm run by the reference engine is a recording; its replay finds the friction."""

import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.identification.axis.joints_rig import JointsRig, joint_replays
from simpter_hybrid.identification.fitting.fit import Fitter
from simpter_hybrid.identification.rigs.corrected import with_parameters
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor

TRUE = {"clutch.1.torque.coulomb": 0.12, "clutch.2.torque.coulomb": 0.05}


@pytest.mark.slow
def test_friction_of_both_joints_comes_back(tmp_path):
    declared = declared_joints()
    replays = joint_replays(recorded_joints(tmp_path, with_parameters(declared, TRUE)))
    predictor = ScenarioPredictor(declared, JointsRig())
    near = {p.name: 1.0 for p in predictor.parameters}
    near |= {"Coulomb friction of the shoulder": 1.4, "Coulomb friction of the elbow": 0.7}
    found = Fitter(predictor, replays).fit(near, iterations=20).values
    # The drive is held for 2 ms in the replay and goes on in the run; starts of windows come from
    # local parabolas: together some 1e-3 of 0.08 N m, with a margin of ten.
    assert 0.08 * found["Coulomb friction of the shoulder"] == pytest.approx(0.12, rel=0.02)
    assert 0.08 * found["Coulomb friction of the elbow"] == pytest.approx(0.05, rel=0.02)
