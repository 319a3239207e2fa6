"""An ensemble's cases are the runs one by one, to the bit, however they are split."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from devices_for_tests import always_on
from random_runs import random_run

pytest.importorskip("llvmlite")
from simpter_hybrid.cases import CannotVary
from simpter_hybrid.compiled import simulate
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.ensemble import ensemble
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.scenario import Scenario

RUN = random_run("controller 30 Hz", 3)
GRID = np.linspace(0.0, 3.0, 31)
CASES = 60
RNG = np.random.default_rng(5)
VARY = {
    "controller.1.stiffness": RNG.uniform(2e3, 8e3, CASES),
    "clutch.2.delay": RNG.uniform(0.0, 0.04, CASES),
    "clutch.3.threshold": RNG.uniform(0.02, 0.2, CASES),
    "qd.theta_1": RNG.uniform(-1.0, 1.0, CASES),
}


@pytest.fixture(scope="module")
def whole():
    return ensemble(RUN, VARY, grid=GRID, trajectories=True)


def test_split_over_threads(whole):
    with ThreadPoolExecutor(2) as executor:
        split = ensemble(RUN, VARY, grid=GRID, executor=executor, chunk=7)
    assert np.array_equal(whole.end, split.end)
    assert np.array_equal(whole.t, split.t)
    assert np.array_equal(whole.rows.tau, split.rows.tau, equal_nan=True)
    assert [whole.events(k) for k in range(CASES)] == [split.events(k) for k in range(CASES)]


def test_a_case_is_the_scenario_with_these_numbers(whole):
    k = 41
    clutches = list(RUN.clutches)
    clutches[1] = replace(clutches[1], delay=float(VARY["clutch.2.delay"][k]))
    clutches[2] = replace(clutches[2], threshold=float(VARY["clutch.3.threshold"][k]))
    first, second = RUN.controllers
    first = (replace(first[0], stiffness=float(VARY["controller.1.stiffness"][k])), first[1])
    qd = (float(VARY["qd.theta_1"][k]), RUN.qd[1])
    one = simulate(RUN.replace(clutches=tuple(clutches), controllers=(first, second), qd=qd))
    assert one.events == whole.events(k)
    assert np.array_equal(one.end, whole.end[k])
    assert np.array_equal(one.step_f, whole.trajectory(k).step_f)


def furthest(rows, end, t):
    return {"furthest": np.nanmax(np.abs(rows.q), axis=(1, 2))}


def test_measures_are_taken_chunk_by_chunk(whole):
    found = ensemble(RUN, VARY, grid=GRID, measure=furthest, chunk=11)
    expected = furthest(whole.rows, whole.end, whole.t)["furthest"]
    assert np.array_equal(found.measures["furthest"], expected)
    assert found.rows is None


@pytest.mark.parametrize(
    ("vary", "word"),
    [
        ({"clutch.1.torque.skale": [1.0]}, "not known"),
        ({"clutch.1.time_constant": [0.0, 0.05]}, "different models"),
        ({"q.theta_1": [0.1], "q.theta_2": [0.1, 0.2]}, "numbers of cases differ"),
        ({"q.theta_1": [0.1, np.nan]}, "case 1 is not finite"),
        ({}, "nothing is varied"),
    ],
)
def test_what_cannot_be_varied_is_refused(vary, word):
    with pytest.raises(CannotVary, match=word):
        ensemble(RUN, vary)


RAMP = Scenario(
    "axis", LinearAxis(mass=1.0), (always_on(1.0, 1.0),), (0.0,), (0.0,), 1.0,
    loads=(RampOnCoordinate(base=1.0, slope=2.0, start=0.2, limit=2.0),),
)  # fmt: skip


@pytest.mark.parametrize("name", ["start", "slope", "base", "limit"])
def test_what_would_move_a_breakpoint_of_a_load_is_refused(name):
    path, own = f"load.1.{name}", getattr(RAMP.loads[0], name)
    with pytest.raises(CannotVary, match=f"{path}: its load has breakpoints in time"):
        ensemble(RAMP, {path: [own, own + 0.1]})
    assert ensemble(RAMP, {path: [own]}).end[0, 1] == simulate(RAMP).end[1]


def test_a_ramp_may_have_no_slope_in_some_cases():
    found = ensemble(RAMP, {"load.1.slope": [0.0, 2.0], "load.1.limit": [1.0, 2.0]}).end[:, 1]
    # 1 N throughout.
    assert found[0] == pytest.approx(RAMP.t_end, rel=1e-9)
    assert found[1] == simulate(RAMP).end[1]


def test_breakpoints_beyond_the_run_may_move():
    late = RAMP.replace(loads=(replace(RAMP.loads[0], start=2.0),))
    found = ensemble(late, {"load.1.base": [1.0, 1.5]}).end[:, 1]
    # 1 kg for a second.
    assert found == pytest.approx([1.0, 1.5], rel=1e-9)


def test_instants_that_do_not_rise_are_refused():
    with pytest.raises(ValueError, match="must rise"):
        ensemble(RAMP, {"q.slide": [0.0]}, grid=np.array([0.0, 0.5, 0.2]))
