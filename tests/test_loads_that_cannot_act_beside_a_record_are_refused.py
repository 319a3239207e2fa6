"""A load that nobody tells what to do, or that goes by a time of its own, is refused by name."""

from dataclasses import dataclass, replace

import pytest
from axis_recordings import declared_axis
from robot_replays import declared as declared_robot

from simpter_hybrid.applied_load import Load
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rotor.rig import RotorRig
from simpter_hybrid.identification.tip.rig import TipRig
from simpter_hybrid.loads.drive import ForceDrive
from simpter_hybrid.loads.motor import HeldTorque
from simpter_hybrid.loads.operator import Operator
from simpter_hybrid.loads.pulled_spring import PulledSpring
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.part import parameter
from simpter_hybrid.problems import InvalidInput

MOVED = PulledSpring(((0.0, 0.0), (1.0, 1.0)), 5.0)
CASES = {
    "a motor on a robot": (declared_robot, TipRig(), ForceDrive(1.0), "nothing tells"),
    "a drive on a rotor": (
        lambda: load(find_model("testbed")), RotorRig(), ForceDrive(1.0), "nothing tells",
    ),
    "a held torque on an axis": (declared_axis, AxisRig(), HeldTorque(), "nothing tells"),
    "a motor beside a pulled spring": (
        lambda: replace(declared_axis(), loads=(MOVED,)), AxisRig(servo=True, played=1e-3),
        ForceDrive(1.0), "nothing tells",
    ),
    "a ramp": (declared_axis, AxisRig(), RampOnCoordinate(1.0, slope=2.0), "time of its own"),
    "a moved spring": (declared_axis, AxisRig(), MOVED, "time of its own"),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_it_is_named_with_its_number(case):
    make, rig, other, why = CASES[case]
    declared = make()
    loads = (*declared.loads, other)
    named = rf"load\.{len(loads)}: .*{why}.*got {type(other).__name__}; expected"
    with pytest.raises(InvalidInput, match=named):
        rig.template(replace(declared, loads=loads))


def test_a_spring_whose_end_stands_still_is_not():
    still = PulledSpring(((0.0, 0.2), (1.0, 0.2)), 5.0)
    loads = (*declared_axis().loads, still)
    assert AxisRig().template(replace(declared_axis(), loads=loads)).loads == loads


def test_nor_may_a_number_of_a_replaced_hand_be_refitted():
    known = {"name": "arm", "parameters": ["load.1.along"], "relative": 0.1}
    hand = replace(declared_robot(), loads=(Operator(5.0, 0.0),), notes={"tolerances": [known]})
    with pytest.raises(InvalidInput, match=r"arm: a number of Operator, .* got .?load\.1\.along"):
        TipRig().template(hand)


@dataclass(frozen=True)
class Detent(Load):
    """A spring towards an angle that is its own number, whatever that is called."""

    at_angle: float = parameter("coordinate", 0.1)

    @staticmethod
    def force(q, Q, at_angle):
        Q[0] -= q[0] - at_angle


def test_a_number_of_its_own_that_sounds_told_is_none():
    loads = (*declared_axis().loads, Detent())
    assert AxisRig().template(replace(declared_axis(), loads=loads)).loads == loads
