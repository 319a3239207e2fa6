from dataclasses import replace

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rotor.library import rotor_library
from simpter_hybrid.identification.rotor.sizes import Sizes, sizes_of


@pytest.fixture(scope="module")
def testbed():
    return load(find_model("testbed"))


def _larger(testbed, torque, inertia):
    first = testbed.clutches[0]
    law = first.torque
    changed = replace(law, scale=torque)
    device = replace(testbed.device, inertia=inertia * testbed.device.inertia)
    clutches = (replace(first, torque=changed), *testbed.clutches[1:])
    return replace(testbed, device=device, clutches=clutches)


def _reach(declared, candidate, parameter):
    found = {c.name: c for c in rotor_library(declared)}[candidate]
    return next(p for p in found.parameters if p.name.endswith(parameter))


def test_the_testbed_is_as_large_as_itself(testbed):
    assert sizes_of(testbed) == Sizes(1.0, 1.0, 1.0, 1.0)
    assert sizes_of(testbed, 2.023) == sizes_of(testbed, 2.0145) == sizes_of(testbed)


@pytest.mark.parametrize("times", [0.01, 30.0])
def test_torques_and_inertias_scale_with_those_declared(testbed, times):
    other = _larger(testbed, torque=times, inertia=times)
    for candidate, parameter in (("bias-force", "bias"), ("added-inertia", "inertia_change")):
        own, its = (_reach(d, candidate, parameter) for d in (testbed, other))
        assert its.upper == pytest.approx(times * own.upper)
        assert its.typical == pytest.approx(times * own.typical)


@pytest.mark.parametrize(
    ("candidate", "parameter", "power"),
    [("play-hysteresis", "width", 1), ("pull-in", "drop_out", 1), ("slew-limit", "slowness", -1)],
)
def test_commands_scale_with_the_full_one(testbed, candidate, parameter, power):
    first = testbed.clutches[0]
    # The torque at full command stays: a quadratic law of a command that is half as large.
    law = replace(first.torque, a=4.0 * first.torque.a, b=2.0 * first.torque.b)
    half = replace(first, torque=law, full_scale=0.5 * first.full_scale)
    other = replace(testbed, clutches=(half, *testbed.clutches[1:]))
    assert sizes_of(other) == Sizes(1.0, 0.5, 1.0)
    own, its = (_reach(d, candidate, parameter) for d in (testbed, other))
    assert its.upper == pytest.approx(0.5**power * own.upper)


@pytest.mark.parametrize(
    ("candidate", "parameter", "power"),
    [("stribeck", "fade", 1), ("viscous-drag", "coefficient", -1),
     ("quadratic-drag", "coefficient", -2)],
)  # fmt: skip
def test_speeds_scale_with_those_of_the_runs(testbed, candidate, parameter, power):
    own, its = (
        next(c for c in rotor_library(testbed, speed=speed) if c.name == candidate)
        for speed in (2.0, 60.0)
    )
    for one, other in zip(own.parameters, its.parameters, strict=True):
        if one.name.endswith(parameter):
            assert other.upper == pytest.approx(30.0**power * one.upper)
