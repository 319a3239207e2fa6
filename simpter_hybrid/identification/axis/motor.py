"""The motor of an axis in a declared scenario, and what of its controller acts on a record."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...loads.drive import ForceDrive, VoltageDrive
from ...scenario import Scenario
from ..recordings.checks import Finding
from .drive_force import turned_by

#: A supply whose recorded values differ by no more than this part of it counts as constant.
SAGS = 0.1


def motor_of(scenario: Scenario) -> tuple[int, float]:
    """Which load drives the axis, and the force for each unit of its drive at rest.

    Raises
    ------
    AssertionError
        If none does, which is refused before anything is planned.
    """
    for k, load in enumerate(scenario.loads):
        if isinstance(load, ForceDrive | VoltageDrive):
            return k, turned_by((load,))
    raise AssertionError("a rig without a motor is refused before anything is planned")


def pulses_untold(declared: Scenario) -> tuple[Finding, ...]:
    """A remark on a motor driven by volts of which nobody said whether they come in pulses."""
    motors = [load for load in declared.loads if isinstance(load, VoltageDrive)]
    if not motors or motors[0].supply > 0.0:
        return ()
    what = "a driver that opens the motor's ends between pulses (drive-coasting) is not tried"
    right = (
        "if the volts are means of pulses: duty and supply in the map, or `supply` of the model's "
        "voltage-drive"
    )
    return (Finding.of_all(what, "no height of pulses", right),)


def with_pulses(declared: Scenario, supply: np.ndarray) -> Scenario:
    """Scenario whose motor's driver gives pulses as high as the recorded `supply`.

    Unchanged where a height is declared, where no supply was recorded, or where it varies too much
    (`SAGS`) for one height.
    """
    if not supply.size or np.ptp(supply) > SAGS * np.median(supply):
        return declared
    height = float(np.median(supply))
    loads = tuple(
        replace(load, supply=height)
        if isinstance(load, VoltageDrive) and load.supply == 0.0
        else load
        for load in declared.loads
    )
    return replace(declared, loads=loads)
