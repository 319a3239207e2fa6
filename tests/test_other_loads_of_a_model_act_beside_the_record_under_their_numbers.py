"""A record takes the place of what it holds; other loads of the model act, each by its number."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis
from robot_replays import declared as declared_robot
from two_joints import declared_joints

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.joints_rig import JointsRig
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.corrected import corrected_scenario
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rotor.rig import RotorRig
from simpter_hybrid.identification.tip.rig import TipRig
from simpter_hybrid.loads.piston import PistonForce
from simpter_hybrid.loads.pulled_spring import PulledSpring, ReplayedPull
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.loads.replayed_force import ReplayedTipForce
from simpter_hybrid.loads.tip_spring import TipSpring

PUSH = RampOnCoordinate(base=2.0)
KNOWN = {"name": "push", "parameters": ["load.1.base"], "relative": 0.1}
RIGS = {
    "axis": (declared_axis, AxisRig()),
    "axis let alone": (declared_axis, AxisRig(alone=True)),
    "axis behind its servo": (declared_axis, AxisRig(servo=True)),
    "joints": (declared_joints, JointsRig()),
    "rotor": (lambda: load(find_model("testbed")), RotorRig()),
    "tip": (declared_robot, TipRig()),
}


def behind(declared, first):
    return replace(declared, loads=(first, *declared.loads), notes={"tolerances": [KNOWN]})


@pytest.mark.parametrize("rig", RIGS)
def test_a_constant_force_is_refitted_in_the_model_that_the_record_drives(rig):
    make, rig = RIGS[rig]
    declared = behind(make(), PUSH)
    predictor = ScenarioPredictor(declared, rig)
    values = {"push": 1.05}
    p, _ = predictor.vector(values)
    assert p[predictor.runner.names["load.1.base"]] == 2.1
    assert corrected_scenario(declared, (), values).loads[0].base == 2.1


def test_the_recorded_force_stands_where_the_hand_was_declared():
    declared = declared_robot()
    loads = (TipSpring(stiffness=10.0), *declared.loads, *declared.loads)
    made = TipRig().template(replace(declared, loads=loads))
    assert made.loads == (loads[0], ReplayedTipForce(), TipSpring())


def test_a_piston_pushes_an_axis_that_is_let_alone():
    loads = (PistonForce(area=20.0), *declared_axis().loads)
    assert AxisRig(alone=True).template(replace(declared_axis(), loads=loads)).loads == loads


def test_a_spring_whose_end_was_recorded_keeps_its_number():
    loads = (PUSH, PulledSpring(((0.0, 0.0), (1.0, 1.0)), 5.0))
    rig = AxisRig(servo=True, played=1e-3)
    made = rig.template(replace(declared_axis(), loads=loads))
    assert made.loads == (PUSH, ReplayedPull(5.0))
