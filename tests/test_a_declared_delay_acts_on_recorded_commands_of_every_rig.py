"""A delay of the model's own acts behind what was recorded, at every sample of the record."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis

from simpter_hybrid.controllers.command_delay import CommandDelay
from simpter_hybrid.controllers.dead_time import DeadTime
from simpter_hybrid.controllers.drive_delay import DriveDelay
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.rig import handed_on
from simpter_hybrid.identification.rotor.rig import RotorRig
from simpter_hybrid.identification.tip.rig import TipRig
from simpter_hybrid.problems import InvalidInput

RIGS = {
    "axis": (declared_axis, AxisRig()),
    "rotor": (lambda: load(find_model("testbed")), RotorRig()),
    "tip": (lambda: load(find_model("robot")), TipRig()),
}


def with_stages(declared, *stages):
    return replace(declared, controllers=(*declared.controllers, *stages))


@pytest.mark.parametrize("rig", RIGS)
def test_it_is_behind_what_plays_the_record_and_runs_as_often(rig):
    declared, template = RIGS[rig]
    late = CommandDelay(delay=0.005)
    made = template.template(with_stages(declared(), (late, 3)))
    assert made.controllers[0][0] != late
    assert made.controllers[1:] == ((late, 1),)


@pytest.mark.parametrize("rig", RIGS)
def test_what_holds_commands_back_itself_is_no_such_stage(rig):
    # A player tells it a new command at every sample, and it would wait for ever.
    declared, template = RIGS[rig]
    made = template.template(with_stages(declared(), (DeadTime(delay=0.005), 1)))
    assert len(made.controllers) == 1


def test_more_than_it_keeps_at_the_pace_of_the_record_is_refused():
    declared = with_stages(declared_axis(), (DriveDelay(delay=0.03), 1))
    assert handed_on(declared, 1e-3)
    with pytest.raises(InvalidInput, match=r"beyond the past that is kept, got .0\.03 s"):
        handed_on(declared, 1e-4)
