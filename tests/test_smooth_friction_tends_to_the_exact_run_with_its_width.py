"""Friction made smooth: a stuck clutch creeps, and the error falls with the width of the tanh."""

import numpy as np
import pytest
from devices_for_tests import Block, Ramp, always_on

from simpter_hybrid.engine import simulate as exact
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.regularised import simulate
from simpter_hybrid.regularised.smooth_friction import without_slip
from simpter_hybrid.scenario import Scenario

ON = {"command": (1.0,), "excitation": (1.0,)}


def block(force: float, brk: float = 1.0) -> Scenario:
    """A block on the ground with slip friction 1 N, pushed with a constant force."""
    corners = ((0.0, force), (1.0, force))
    return Scenario(
        "block", Block(2.0), (always_on(1.0, brk),), (0.0,), (0.0,), 1.0,
        loads=(Ramp(0.0, corners),), **ON,
    )  # fmt: skip


@pytest.mark.parametrize("solver", ["Radau", "BDF", "LSODA"])
def test_a_held_block_creeps_at_the_speed_of_the_formula(solver):
    found = simulate(block(0.5), 1e-3, solver, rtol=1e-8, atol=1e-11)
    # tanh(v / width) = 1/2; approached with time constant mass * width / force slope: 3 ms.
    creep = 1e-3 * np.arctanh(0.5)
    assert found.end[1] == pytest.approx(creep, rel=1e-5)


def test_the_breakaway_torque_is_reached_at_ten_widths():
    # 1.29 N of 1.3 N: held, though slip friction is 1 N; 1.31 N is too much.
    assert simulate(block(1.29, 1.3), 1e-3).end[1] < 1e-2
    assert simulate(block(1.31, 1.3), 1e-3).end[1] > 1e-2


def test_the_error_falls_with_the_width():
    run = load("reduced-clutch-2")
    end = exact(run).end
    errors = [
        np.abs(simulate(run, width, "LSODA", 1e-8, 1e-11).end - end)[:2].max()
        for width in (1e-2, 1e-3, 1e-4)
    ]
    # width log(width): between a factor of five and ten a decade.
    assert errors[0] > 5.0 * errors[1] > 25.0 * errors[2]


def test_controllers_read_no_creep():
    assert without_slip([[1.0, -1.0]], [0.3, 0.3 + 1e-6]) in ([0.3, 0.3], [0.3 + 1e-6] * 2)
    assert without_slip([[1.0, -1.0], [1.0, 1.0]], [0.3, 0.2]) == [0.0, 0.0]
    assert without_slip([], [0.3, 0.2]) == [0.3, 0.2]


def test_wrong_settings_are_refused():
    with pytest.raises(ValueError, match=r"width = -1\.0 must be a positive"):
        simulate(block(0.5), -1.0)
    with pytest.raises(ValueError, match="choose one of Radau, BDF, LSODA"):
        simulate(block(0.5), 1e-3, "RK4")
