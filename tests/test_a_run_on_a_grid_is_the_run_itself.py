"""Rows on a grid against the dense run; restarts; parameters that change without compiling anew."""

import numpy as np
import pytest
from random_runs import random_run

pytest.importorskip("llvmlite")
from simpter_hybrid.compiled import simulate
from simpter_hybrid.measuring.evaluation import Evaluation
from simpter_hybrid.on_grid import GridRun, simulate_on_grid

RUN = random_run("30 Hz", 7)
GRID = np.linspace(0.0, 3.0, 41)


@pytest.fixture(scope="module")
def rows():
    return simulate_on_grid(RUN, GRID)


def test_states_are_those_of_the_dense_run(rows):
    run = simulate(RUN)
    states = np.array([run.state(t, "left") for t in GRID])
    # The dense run leaves the dependent speeds of a stuck set to the polynomial: rounding.
    assert np.abs(rows.q - states[:, :2]).max() == 0.0
    assert np.abs(rows.qd - states[:, 2:4]).max() < 1e-13
    assert np.abs(rows.excitation - states[:, 4:8]).max() == 0.0


def test_accelerations_and_torques_are_those_of_the_python_model(rows):
    run = simulate(RUN)
    model = Evaluation(run)
    for k in range(1, len(GRID), 3):
        segment = run.segment_at(GRID[k], "left")
        model.enter(segment)
        model.at(GRID[k], run.state(GRID[k], "left").tolist())
        # The same formulas in the same order; libraries may round a sine differently.
        assert np.allclose(rows.qdd[k], model.w.qdd, rtol=1e-11, atol=1e-11)
        assert np.allclose(rows.tau[k], model.w.tau[:4], rtol=1e-11, atol=1e-11)
        assert np.array_equal(rows.held[k], run.held[segment])


def test_a_restart_where_the_run_is_anyway_changes_nothing(rows):
    slipping = [k for k in range(5, 40) if (rows.qd[k] != 0.0).all()][::9]
    at = GRID[slipping]
    again = GridRun(RUN, GRID, (at, rows.q[slipping], rows.qd[slipping]))()
    # Restarted from numbers at an instant: only the division into steps differs.
    assert np.abs(again.q - rows.q).max() < 1e-9


def test_a_restart_sets_the_motion_and_keeps_the_excitations(rows):
    at, q, qd = np.array([1.0]), np.array([[0.7, 1.5]]), np.array([[0.3, -0.2]])
    grid = np.array([1.0, 1.0 + 1e-9])
    before = simulate_on_grid(RUN, grid)
    after = simulate_on_grid(RUN, grid, (at, q, qd))
    assert np.array_equal(after.q[0], before.q[0])
    assert np.allclose(after.q[1], q[0], atol=1e-8)
    assert np.allclose(after.qd[1], qd[0], atol=1e-6)
    assert np.array_equal(after.excitation[1], before.excitation[1])


def test_parameters_change_without_compiling():
    run = GridRun(RUN, GRID)
    heavier = simulate_on_grid(
        RUN.replace(device=RUN.device.__class__(30.0, 8.0, -1.0, 0.92, 0.61)), GRID
    )
    changed = run({"device.alpha": 30.0, "device.beta": 8.0, "device.gamma": -1.0})
    assert np.array_equal(changed.q, heavier.q)


def test_a_failure_is_nan_and_a_message():
    found = simulate_on_grid(RUN, GRID, values={"device.alpha": 0.0, "device.beta": 0.0,
                                                "device.gamma": 0.0})  # fmt: skip
    assert found.status == "failed"
    assert "singular" in found.message or "not finite" in found.message
    assert np.isnan(found.q[-1]).all()


@pytest.mark.parametrize("side", [-np.inf, np.inf])
def test_the_last_row_is_there_though_a_sample_falls_a_rounding_before_the_end(side):
    end = float(np.nextafter(10 * RUN.period, side))
    last = simulate_on_grid(RUN.replace(t_end=end), np.array([0.1, end]))
    plain = simulate_on_grid(RUN.replace(t_end=10 * RUN.period), np.array([0.1, 10 * RUN.period]))
    assert np.abs(last.q[-1] - plain.q[-1]).max() < 1e-14
