"""Two joints: candidates of directions, loads and drives, and no common size of N and N m."""

from dataclasses import replace

import pytest
from two_joints import declared_joints

from simpter_hybrid.device import Device
from simpter_hybrid.effects.drive_gain import DriveGain
from simpter_hybrid.identification.tip.joint_candidates import joint_candidates


def library(device=None, commanded=(), travels=(0.5, 2.0)):
    declared = declared_joints()
    declared = declared if device is None else replace(declared, device=device)
    made = joint_candidates(declared, (0.1, 0.2), 1.0, 2.0, (3.0, 4.0), commanded, travels)
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


def test_lengths_and_angles_share_no_size_and_a_length_has_no_weight():
    angles, mixed = library(), library(CartAndPendulum())
    assert {"viscous-drag", "dry-drag"} <= angles.keys()
    assert not {"viscous-drag", "dry-drag"} & mixed.keys()
    assert mixed["viscous-drag by joint"].listed
    assert [e.coordinate for e in mixed["tilt"].effects()] == [1]


def test_actuators_are_asked_of_clutches_whose_commands_were_recorded():
    assert library(commanded=(1,))["second-lag by clutch"].places == ("2",)
    assert library(commanded=(0, 1))["second-lag by clutch"].places == ("1", "2")
    assert "second-lag by clutch" not in library()


@pytest.mark.parametrize("commanded", [(), (0,), (1,), (0, 1)])
def test_none_is_left_without_a_number(commanded):
    assert all(c.parameters for c in library(commanded=commanded).values())


def test_friction_may_give_way_at_either_joint_alone_over_a_part_of_its_own_way():
    made = library()
    assert made["presliding by clutch"].places == ("1", "2")
    for label, way in (("1", 0.5), ("2", 2.0)):
        one = made[f"presliding by clutch {label}"]
        assert [e.clutch for e in one.effects()] == [int(label) - 1]
        assert one.at == (f"clutch {label}",)
        assert one.parameters[0].upper == pytest.approx(0.5 * way)
    assert "presliding" in made
    assert "presliding" not in library(CartAndPendulum())  # metres and radians


def test_of_a_joint_that_stood_no_presliding_is_asked():
    names = [name for name in library(travels=(0.0, 2.0)) if name.startswith("presliding")]
    assert names == ["presliding by clutch 2"]
