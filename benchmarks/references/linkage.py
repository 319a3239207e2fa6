"""The run that every solver can express: four clutches with constant friction on PTER's linkage.

Inertia is the baseline's; a clutch's breakaway torque equals its slip torque, is constant and acts
from the start; both links are pushed by sinusoids.  Sticking, redundant sets and simultaneous stops
occur, switching does not.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "tests"))

from random_runs import Quadratic, Sines

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.laws import LBF_IN
from simpter_hybrid.scenario import Scenario

DEVICE = Pter(150.0 * LBF_IN, 45.0 * LBF_IN, -12.0 * LBF_IN, 0.92456, 0.61214)
#: Friction torques [N m].
TORQUES = (9.0, 6.0, 4.0, 3.0)
START = (0.7, 1.6)
T_END = 3.0
#: Offset and sinusoids (coordinate, N m, rad/s, rad) of the load.
LOAD = Sines(
    3.0, -2.0,
    ((0.0, 22.0, 6.0, 0.4), (1.0, 15.0, 4.1, 2.0), (0.0, 8.0, 15.0, 1.0), (1.0, 6.0, 11.0, 5.0)),
)  # fmt: skip


def linkage() -> Scenario:
    """The run as a scenario."""
    clutches = tuple(Clutch(Quadratic(0.0, 0.0, torque, 0.0, 1.0)) for torque in TORQUES)
    on = (1.0,) * 4
    return Scenario(
        "linkage", DEVICE, clutches, START, (0.0, 0.0), T_END,
        loads=(LOAD,), command=on, excitation=on,
    )  # fmt: skip
