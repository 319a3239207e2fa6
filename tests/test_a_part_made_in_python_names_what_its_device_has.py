"""Numbers of clutches and coordinates, with one of each: any other would be another cell."""

import dataclasses

import pytest

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.controllers.profile import CommandProfile
from simpter_hybrid.effects.stray_field import StrayField
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.loads.piston import PistonForce
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.stop import CoordinateLimit

BAR = load("torque-bar-12v")
HELD = CommandProfile(((0.0, 1.0),))
PARTS = {
    "loads": RampOnCoordinate(0.5, coordinate=1.0),
    "loads, below 0": RampOnCoordinate(0.5, coordinate=-1.0),
    "loads, between": RampOnCoordinate(0.5, coordinate=0.5),
    "loads, of a clutch": PistonForce(1.0, clutch=1.0),
    "stops": CoordinateLimit(1.0, 2.0),
    "effects": StrayField(clutch=0, gain=0.5, neighbour=3.0),
}


@pytest.mark.parametrize("name", PARTS)
def test_a_part(name):
    family = name.partition(",")[0]
    right = f"{family}\\.\\d\\.\\w+: no such (clutch|coordinate), got .*; expected .*: 0 for "
    parts = (*getattr(BAR, family), PARTS[name])
    with pytest.raises(InvalidInput, match=right):
        validate(BAR.replace(**{family: parts}))


def test_a_stage():
    stages = ((HELD, 1), (dataclasses.replace(HELD, clutch=1.0), 1))
    with pytest.raises(InvalidInput, match=r"stages\.1\.clutch: no such clutch, got \"1\""):
        validate(BAR.replace(controllers=stages, period=0.01))
