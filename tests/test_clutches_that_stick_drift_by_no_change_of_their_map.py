"""What a clutch slips is the integral of its slip velocity, also where its map turns."""

import numpy as np

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.comparison.compare import drift
from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.engine import simulate
from simpter_hybrid.laws.axis_friction import CoulombViscous
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.scenario import Scenario


def test_an_exact_run_of_an_arm_drifts_by_rounding():
    clutches = tuple(
        Clutch(CoulombViscous(coulomb=force, stiction=0.2), time_constant=0.01, delay=0.0,
               full_scale=10.0, threshold=-1.0)
        for force in (0.5, 0.4, 0.3, 1.0, 1.0)
    )  # fmt: skip
    arm = Scenario(
        "arm", PlanarArm(), clutches, (0.3, 0.9, 1.4), (0.0, 0.0, 0.0), 3.0,
        loads=(RampOnCoordinate(0.0, 1.0, coordinate=1.0),), command=(5.0,) * 5,
        excitation=(5.0,) * 5,
    )  # fmt: skip
    run = simulate(arm)
    stuck = run.mode[run.segment_t[:, 0] > 1.6] == 0
    assert np.logical_xor(stuck.any(axis=1), stuck.all(axis=1)).any()  # it moves, and some stick
    assert drift(run) < 1e-12
