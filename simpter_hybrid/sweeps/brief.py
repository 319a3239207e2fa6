"""Measures of a case: few and quickly taken, or all that a run's summary has."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import Any

import numpy as np

from ..device import Device
from ..measuring.metrics import (
    Metrics,
    as_measured,
    differences,
    instants,
    measures,
    path_measures,
    saturation_time,
    time_weighted_average,
)
from ..measuring.sampling import sample
from ..measuring.transitions import transitions
from ..trajectory import Trajectory

#: Measures by name, as columns of a table.
Measured = dict[str, float | None]
#: A measure of one's own: of a run, numbers by name.
OwnMeasure = Callable[[Trajectory], Mapping[str, float]]
#: Of fewer instants no mean, no path and no rate of change is known.
FEWEST = 3
#: What is taken at the instants of the step.
STEPPED = (
    "average_error", "max_error", "path_length", "average_acceleration", "average_jerk", "max_jerk"
)  # fmt: skip
#: Of ``STEPPED`` what a tip alone has.
OF_A_TIP = ("average_error", "max_error", "path_length")
#: What ``brief`` takes besides those of a tip and of single clutches.
BRIEF = (
    "run_time", "events", "average_acceleration", "average_jerk", "max_jerk", "transitions",
    "reversals", "energy_from_user",
)  # fmt: skip
PER_CLUTCH = ", per clutch"
#: Unit and words for what ``Metrics`` does not name.
MORE = {
    "events": ("", "events"),
    "reversals": ("", "reversals of slip without rest"),
}


def after(instants: np.ndarray, t_end: float) -> np.ndarray:
    """The next larger floats, by which the compiled engine shows what is after an event there.

    Parameters
    ----------
    instants : ndarray (N,)
        [s].
    t_end : float
        No instant is later [s].
    """
    return np.minimum(np.nextafter(instants, np.inf), t_end)


def brief(trajectory: Trajectory, step: float, tip: Any, acceleration: np.ndarray) -> Measured:
    """The measures taken of every case; None for what fewer than three instants do not tell.

    They are those of ``metrics.measures`` without what needs the model evaluated at every event,
    under the same names where one number serves: ``reversals`` are those of all clutches, and each
    clutch has a ``saturation_time.<number>`` of its own. ``events`` counts those of the run.

    Parameters
    ----------
    trajectory : Trajectory
    step : float
        Sampling step [s].
    tip : ndarray, (N, 2), or None
        At ``instants(trajectory.t_end, step)`` [m].
    acceleration : ndarray, (N, k)
        Of the tip [m/s^2], or of the coordinates where there is no tip.
    """
    t = instants(trajectory.t_end, step)
    jerk = differences(t, acceleration)
    counted = transitions(trajectory)
    found: Measured = {"run_time": trajectory.t_end, "events": len(trajectory.events)}
    if tip is not None:
        found |= path_measures(trajectory.scenario, tip)
    size = np.linalg.norm(acceleration, axis=1)
    found["average_acceleration"] = time_weighted_average(t, size)
    found["average_jerk"] = time_weighted_average(t, jerk)
    found["max_jerk"] = float(jerk.max())
    found["transitions"] = counted.total
    found["reversals"] = sum(counted.reversals)
    for i, seconds in enumerate(saturation_time(trajectory)):
        found[f"saturation_time.{i + 1}"] = seconds
    z = trajectory.scenario.sizes()
    found["energy_from_user"] = float(trajectory.end[2 * z["n"] + z["m"] + z["nz"]])
    return known(found, len(t))


def known(found: Measured, count: int) -> Measured:
    """Measures without the numbers that ``count`` instants of a run do not tell.

    Parameters
    ----------
    found : mapping
        Measures by name.
    count : int
        Instants at which those of ``STEPPED`` were taken.
    """
    if count >= FEWEST:
        return found
    return {name: None if name in STEPPED else value for name, value in found.items()}


def sampled(trajectory: Trajectory, step: float) -> Measured:
    """``brief`` of a run of either engine, the model evaluated in Python.

    Parameters
    ----------
    trajectory : Trajectory
    step : float
        Sampling step [s].
    """
    taken = sample(trajectory, instants(trajectory.t_end, step))
    return brief(trajectory, step, taken.tip, taken.acceleration)


def everything(trajectory: Trajectory, step: float) -> Measured:
    """All of ``metrics.measures``, entries a clutch under ``name.1`` ...; about a second a run.

    Parameters
    ----------
    trajectory : Trajectory
    step : float
        Sampling step [s].
    """
    found: Measured = {}
    for name, entry in measures(trajectory, step).as_dict().items():
        value = entry["value"]
        if isinstance(value, list):
            found |= {f"{name}.{i + 1}": v for i, v in enumerate(value)}
        else:
            found[name] = value
    found = known(found, len(instants(trajectory.t_end, step)))
    return {"events": len(trajectory.events), **found}


def unit_and_label(name: str, device: Device | None = None) -> tuple[str, str]:
    """SI unit of a measure and the words for it.

    Parameters
    ----------
    name : str
        ``max_error``, or ``saturation_time.1`` for one of a clutch; a name that is not known is its
        own label.
    device : Device, optional
        Whose runs were measured; else one with a tip whose surfaces turn.
    """
    stem, _, number = name.partition(".")
    told = (f for f in fields(Metrics) if f.metadata)  # the device is no measure
    known = {f.name: (f.metadata["unit"], f.metadata["label"]) for f in told} | MORE
    unit, label = known.get(stem, ("", stem.replace("_", " ")))
    unit, label = as_measured(unit, label, device)
    label = label.removesuffix(PER_CLUTCH)
    return unit, f"{label}, clutch {number}" if number else label


def measure_names(measures: str, device: Device) -> list[str]:
    """Names of the measures that runs of a device can have.

    Parameters
    ----------
    measures : str
        ``brief`` or ``all``.
    device : Device
    """
    clutches = range(1, device.m + 1)
    if measures == "brief":
        tip = OF_A_TIP if "tip" in device.functions() else ()
        return [*BRIEF, *tip, *(f"saturation_time.{i}" for i in clutches)]
    names = ["events"]
    for f in fields(Metrics):
        if f.metadata:
            each = f.metadata["label"].endswith(PER_CLUTCH)
            names += [f"{f.name}.{i}" for i in clutches] if each else [f.name]
    return names
