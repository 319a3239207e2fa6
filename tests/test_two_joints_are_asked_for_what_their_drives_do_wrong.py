"""Two joints: candidates of directions, loads and drives, and no common size of N and N m."""

from dataclasses import replace

import pytest
from two_joints import declared_joints

from simpter_hybrid.device import Device
from simpter_hybrid.effects.drive_gain import DriveGain
from simpter_hybrid.identification.tip.joint_candidates import joint_candidates


def library(device=None, pressed=False):
    declared = declared_joints()
    declared = declared if device is None else replace(declared, device=device)
    made = joint_candidates(declared, (0.1, 0.2), 1.0, 2.0, (3.0, 4.0), pressed)
    return {c.name: c for c in made}


class CartAndPendulum(Device):
    """As much of a device as the library asks for."""

    coordinate_dimensions = ("length", "angle")
    n, m = 2, 2


def test_drives_have_the_constants_of_their_motors():
    gains = library()["drive-gain"].effects()
    assert gains == tuple(DriveGain(coordinate=j, constant=k) for j, k in enumerate((3.0, 4.0)))


@pytest.mark.parametrize("name", ["asymmetry-level", "load-dependent", "drive-gain", "drive-lag"])
def test_each_has_a_size_for_each_joint(name):
    candidate = library()[name]
    assert candidate.places == ("1", "2")
    assert candidate.listed


def test_a_lag_is_begun_at_either_joint_and_at_both():
    lag = library()["drive-lag"]
    least = lag.parameters[0].value
    assert {tuple(x > least for x in start) for start in lag.starts} == {
        (True, False), (False, True), (True, True),
    }  # fmt: skip


def test_lengths_and_angles_share_no_size_and_no_weight():
    angles, mixed = library(), library(CartAndPendulum())
    assert {"viscous-drag", "tilt"} <= angles.keys()
    assert not {"viscous-drag", "dry-drag", "tilt"} & mixed.keys()
    assert mixed["viscous-drag by joint"].listed


def test_actuators_of_clutches_are_asked_where_their_commands_were_recorded():
    assert "second-lag" in library(pressed=True)
    assert "second-lag" not in library()
