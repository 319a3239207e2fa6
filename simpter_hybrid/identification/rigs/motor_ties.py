"""Numbers that effects on a drive share with its motor: where a fit moves one, it moves both.

A dead band that kept the declared constant beside a motor refitted to half of it would drive the
axis backwards; so would one that takes more than a limit leaves.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ...applied_load import Load
from ...effects.drive_deadband import DriveDeadband
from ...effects.drive_limit import DriveLimit
from ...loads.drive import ForceDrive, VoltageDrive
from ...scenario import Scenario

#: Name of a number of the model -> its value.
Known = Callable[[str], float]


def tied_numbers(scenario: Scenario, declared: Known, fitted: Known) -> dict[str, float]:
    """Factors on numbers of effects whose motor was refitted; of the others there are none.

    A number that has a tolerance of its own follows that.

    Parameters
    ----------
    scenario : Scenario
        With all effects that act; its notes hold the tolerances.
    declared, fitted : callable
        Number of a motor by its name (``load.1.constant``), before and after the fit.
    """
    free = {n for t in scenario.notes.get("tolerances", ()) for n in t["parameters"]}
    found: dict[str, float] = {}
    for number, effect in enumerate(scenario.effects, 1):
        for field in effect.of_motor:
            name = f"effect.{number}.{type(effect).__name__}.{field}"
            before = _of_motors(scenario.loads, effect.coordinate, field, declared)
            after = _of_motors(scenario.loads, effect.coordinate, field, fitted)
            if name not in free and after != before != 0.0:
                found[name] = after / before
    return found


def follow_motor(
    p: np.ndarray, default: np.ndarray, names: Mapping[str, int], scenario: Scenario
) -> None:
    """Set, in place, what effects share with their motor in a parameter vector (np,).

    `default` is the vector as declared, `names` tells the entries of both.
    """
    factors = tied_numbers(
        scenario, lambda name: float(default[names[name]]), lambda name: float(p[names[name]])
    )
    for name, factor in factors.items():
        p[names[name]] *= factor
    for name, most in dead_at_limits(scenario, lambda name: float(p[names[name]])).items():
        p[names[name]] = most


def dead_at_limits(scenario: Scenario, known: Known) -> dict[str, float]:
    """Widths of dead bands that would take more than a limit beside them leaves: that limit.

    Both are taken from what was told: a wider one would turn the drive round.  A negative gain or a
    saturation beside it still may, since each takes its own part of what was told.
    """
    if sum(isinstance(e, DriveDeadband | DriveLimit) for e in scenario.effects) < 2:
        return {}
    found: dict[str, float] = {}
    named = [(f"effect.{k}.{type(e).__name__}", e) for k, e in enumerate(scenario.effects, 1)]
    for name, dead in named:
        beside = [
            known(f"{other}.limit") for other, e in named
            if isinstance(e, DriveLimit) and e.coordinate == dead.coordinate
        ]  # fmt: skip
        if isinstance(dead, DriveDeadband) and known(f"{name}.width") > min(beside, default=np.inf):
            found[f"{name}.width"] = min(beside)
    return found


def _of_motors(loads: Sequence[Load], coordinate: int, field: str, known: Known) -> float:
    """A motor's ``constant`` at rest, or its ``back``, of all on a coordinate together."""
    total = 0.0
    for number, load in enumerate(loads, 1):
        if not isinstance(load, ForceDrive | VoltageDrive) or int(load.coordinate) != coordinate:
            continue
        constant = known(f"load.{number}.constant")
        if isinstance(load, VoltageDrive):
            by_speed = constant if field == "back" else 1.0
            total += constant * by_speed / known(f"load.{number}.resistance")
        elif field == "constant":
            total += constant
    return total
