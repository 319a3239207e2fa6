"""One way only: asked of a rotor's friction, of the one balance of an axis, of every joint."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.trace import Trace
from simpter_hybrid.identification.tracing.traced import one_way


def _trace(directions):
    nothing = np.zeros(len(directions))
    return Trace(nothing, nothing, {"direction": np.array(directions, float)})


def found(balance, directions):
    return SimpleNamespace(fit={balance: [_trace(directions)]})


@pytest.mark.parametrize("balance", ["friction", "force", "joint_1"])
def test_a_motion_to_one_side_with_rests_is_one_way(balance):
    assert one_way(found(balance, [1.0] * 60 + [0.0] * 40))
    assert not one_way(found(balance, [1.0] * 60 + [-1.0] * 40))


@pytest.mark.parametrize(("other", "way"), [(-1.0, True), ((-1.0, 1.0), False)])
def test_every_joint_has_to(other, way):
    both = {"joint_1": [_trace([1.0] * 60)], "joint_2": [_trace(np.resize(other, 60))]}
    assert one_way(SimpleNamespace(fit=both)) == way


def test_where_no_direction_is_known_nothing_is_said():
    nothing = np.zeros(60)
    assert not one_way(SimpleNamespace(fit={"force": [Trace(nothing, nothing, {})]}))
    assert not one_way(found("load", [1.0] * 60))


@pytest.mark.parametrize(("back", "way"), [(-0.1, True), (-3.0, False)])
def test_a_row_that_smoothing_sends_back_is_no_motion_that_way(back, way):
    speed = np.array([back] + [1.0] * 40)
    told = {"direction": np.sign(speed), "slip_velocity": speed}
    assert one_way(SimpleNamespace(fit={"force": [Trace(speed, speed, told)]})) == way
