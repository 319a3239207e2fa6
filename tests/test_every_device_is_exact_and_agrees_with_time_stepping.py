"""Every device, plain and extended: energy, exact stiction, Moreau's time stepping."""

import numpy as np
import pytest
from devices_for_tests import Coulomb, Waves

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.belt_and_mass import BeltAndMass
from simpter_hybrid.devices.extended import with_drag, with_mount, with_shaft
from simpter_hybrid.devices.force_feedback_mouse import ForceFeedbackMouse
from simpter_hybrid.devices.one_axis import LinearAxis, OneAxis
from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.devices.shaft_pair import ShaftPair
from simpter_hybrid.devices.testbed import SensorTestbed, Testbed
from simpter_hybrid.devices.two_link import TwoLink
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.reading.kinds import shipped
from simpter_hybrid.scenario import Scenario

T_END = 1.5
#: Device, load lines (coordinate, amplitude, rad/s, phase), slip torques, start.
CASES = {
    "mouse": (
        ForceFeedbackMouse(0.1, 0.12), ((0, 2.0, 5.0, 0.3), (1, 1.5, 7.0, 1.0)),
        (0.8, 0.5, 0.4, 0.3), (0.0, 0.0), (0.3, -0.2),
    ),
    "shafts": (
        ShaftPair(0.1, 0.05), ((0, 1.0, 4.0, 0.0), (1, 0.8, 6.0, 2.0)), (0.5, 0.4),
        (0.0, 0.0), (1.0, 0.2),
    ),
    "planar arm": (
        PlanarArm(), ((0, 2.0, 5.0, 0.0), (1, 1.5, 7.0, 1.0), (2, 0.8, 4.0, 2.0)),
        (0.6, 0.5, 0.3, 0.9, 0.7), (0.3, 0.9, -0.4), (0.3, -0.2, 0.4),
    ),
    "two-link": (
        TwoLink(0.5, 0.6, 0.2, 0.2, 0.25, 0.03, 0.05, gravity=0.0),
        ((0, 0.5, 5.0, 0.0), (1, 0.4, 7.0, 1.0)), (0.2, 0.15), (0.3, 0.9), (0.3, -0.2),
    ),
    "pendulum": (OneAxis(0.1, 2.0, 0.3), ((0, 1.5, 6.0, 0.0),), (0.4,), (0.8,), (0.0,)),
    "table": (LinearAxis(95.0), ((0, 60.0, 6.0, 0.0),), (30.0,), (0.0,), (0.1,)),
    "testbed": (Testbed(0.1), ((0, 1.5, 6.0, 0.0),), (1.1,), (0.0,), (2.0,)),
    "sensor testbed": (
        SensorTestbed(0.1, 0.03, 8.0, 0.0), ((0, 1.5, 6.0, 0.0),), (0.6,), (0.0, 0.0), (2.0, 0.0),
    ),
    "belt": (BeltAndMass(1.0, 40.0, 1e3), (), (2.0,), (0.0, 0.0), (0.3, 0.3)),
    "two-link under gravity": (
        TwoLink(0.5, 0.6, 0.2, 0.2, 0.25, 0.03, 0.05, gravity=3.0),
        ((0, 0.5, 5.0, 0.0), (1, 0.4, 7.0, 1.0)), (0.5, 0.4), (0.3, 0.9), (0.3, -0.2),
    ),
    "compliant shaft": (
        with_shaft(ShaftPair(0.1, 0.05), 0, 0.02, 20.0), ((0, 1.0, 4.0, 0.0), (1, 0.8, 6.0, 2.0)),
        (0.5, 0.4), (0.0, 0.0, 0.0), (0.7, 0.2, 0.0),
    ),
    "clutch on a mount": (
        with_mount(OneAxis(0.1, 2.0, 0.3), 0, 0.03, 8.0), ((0, 1.5, 6.0, 0.0),), (0.4,),
        (0.8, 0.0), (0.0, 0.0),
    ),
    "mouse with drag": (
        with_drag(ForceFeedbackMouse(0.1, 0.12), 3), ((0, 2.0, 5.0, 0.3), (1, 1.5, 7.0, 1.0)),
        (0.8, 0.5, 0.4, 0.2, 0.15), (0.0, 0.0), (0.3, -0.2),
    ),
}  # fmt: skip


def run_of(name):
    device, lines, slip, q, qd = CASES[name]
    clutches = tuple(
        Clutch(Coulomb(s, 1.2 * s), time_constant=0.0, delay=0.0, threshold=0.5) for s in slip
    )
    on = (1.0,) * device.m
    run = Scenario(name, device, clutches, q, qd, T_END, command=on, excitation=on)
    found = simulate(run.replace(loads=(Waves(lines),)))
    assert found.status == "finished", found.message
    return found


@pytest.mark.parametrize("name", CASES)
def test_energy_and_stiction_are_exact(name):
    run = run_of(name)
    seen = sample(run, np.linspace(0.0, T_END, 200))
    stuck = seen.mode == 0
    assert stuck.any()
    assert not stuck.all()
    assert energy_balance(run, seen).relative < 1e-8
    device = run.scenario.device
    for k in np.flatnonzero(stuck.any(axis=1)):
        C = [0.0] * (device.m * device.n)
        device.functions()["clutch_map"](seen.q[k].tolist(), run.scenario.parameter_values(), C)
        rows = np.array(C).reshape(device.m, device.n)
        slip = rows @ seen.qd[k]
        # Exactly zero for a constant map; rounding of the map otherwise, and of the sum written
        # above where a row has three entries.
        exact = device.constant_clutch_map and np.count_nonzero(rows, axis=1).max() <= 2
        limit = 0.0 if exact else 1e-14
        assert abs(slip[stuck[k]]).max() <= limit


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=[pytest.mark.slow] if n == "mouse" else []) for n in CASES]
)
def test_time_stepping_converges_to_the_run_at_first_order(name):
    pytest.importorskip("numba", reason="the reference needs Numba")
    from time_stepping import errors_of

    device, lines, slip, q, qd = CASES[name]
    state = run_of(name).end[: 2 * device.n]
    brk = [1.2 * s for s in slip]
    errors, _ = errors_of(device, lines, q, qd, slip, brk, T_END, 500, 4, state)
    # Events that fall early or late in a step scatter single ratios: the order by least squares.
    order = -np.polyfit(np.arange(5), np.log2(errors), 1)[0]
    assert 0.7 < order < 1.4, errors


def test_no_shipped_device_is_left_out():
    # PTER has its own tests, of energy, stiction and time stepping.
    shown = {type(device).__name__ for device, *_ in CASES.values()} | {"Pter"}
    assert {cls.__name__ for cls in shipped("device").values()} <= shown
