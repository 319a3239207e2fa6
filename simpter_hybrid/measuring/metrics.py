"""Measures of a run: the thesis's (its equations (44)-(46)) and well-defined ones beside them."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np

from ..device import Device, surface_word
from ..trajectory import Trajectory
from .desired_path import desired_path
from .evaluation import states
from .samples import Samples
from .sampling import output_grid, sample
from .transitions import transitions
from .variation import total_variation

#: Parts of a solver's step between which the work of a load counts as going one way.
PARTS = 8


def measure(unit: str, label: str) -> Any:
    """A field with its SI unit and the words for it in reports."""
    return field(metadata={"unit": unit, "label": label})


@dataclass(frozen=True)
class Metrics:
    """Measures of one run, SI. None where a run has no such thing (no path, no desired torques).

    Acceleration is the tip's, or that of the coordinates where the device has no tip. Entries a
    clutch are tuples (m,).
    """

    step: float = measure("s", "sampling step of the averages below")
    run_time: float = measure("s", "duration")
    # None for a device or a scenario without a path.
    average_error: Any = measure("m", "average path error, weighted by path length (44)")
    max_error: Any = measure("m", "largest path error")
    path_length: Any = measure("m", "path length of the tip")
    average_acceleration: float = measure("m/s^2", "average acceleration (45)")
    max_acceleration: float = measure("m/s^2", "largest acceleration")
    average_jerk: float = measure("m/s^3", "average jerk (46), differences over the sampling step")
    max_jerk: float = measure("m/s^3", "largest such jerk; grows without bound as the step shrinks")
    variation_smooth: float = measure("m/s^3", "total variation of acceleration a second: smooth")
    variation_jumps: float = measure("m/s^3", "total variation of acceleration a second: jumps")
    flat_portions: tuple[int, ...] = measure("", "flat portions of slip velocity, per clutch")
    transitions: int = measure("", "transitions, counted as in the thesis: flat portions in all")
    reversals: tuple[int, ...] = measure("", "reversals of slip without rest, per clutch")
    torque_following: tuple[float, ...] | None = measure(
        "N m", "rms of |torque| less desired torque, per clutch"
    )
    saturation_time: tuple[float, ...] = measure("s", "time at full-scale command, per clutch")
    energy_from_user: float = measure("J", "energy taken from the user")
    energy_given_back: float = measure("J", "thereof given back meanwhile")
    #: Whose run it is: surfaces of a slide transmit forces, and coordinates may be angles.
    device: Device | None = field(default=None, repr=False)

    def as_dict(self) -> dict[str, dict[str, Any]]:
        """Value, unit and label of every measure by name, ready for JSON."""
        found = {}
        for f in fields(self):
            if not f.metadata:
                continue
            value = getattr(self, f.name)
            value = list(value) if isinstance(value, tuple) else value
            unit, label = as_measured(f.metadata["unit"], f.metadata["label"], self.device)
            found[f.name] = {"value": value, "unit": unit, "label": label}
        return found


def as_measured(unit: str, label: str, device: Device | None) -> tuple[str, str]:
    """SI unit and words of a measure for a device.

    Parameters
    ----------
    unit, label : str
        For one with a tip whose surfaces turn.
    device : Device or None
        None is such a one.
    """
    if device is None:
        return unit, label
    if unit == "N m":
        transmitted = device.surface_units[1]
        unit, label = transmitted, label.replace("torque", surface_word(transmitted))
    if "tip" not in device.functions() and unit.startswith("m/s^"):
        kinds = set(device.coordinate_dimensions) or {"angle"}
        alike = {"angle": "rad", "length": "m"}[min(kinds)] if len(kinds) == 1 else ""
        unit = unit.replace("m", alike or "coordinate unit", 1)
    return unit, label


def path_weighted_average(points: np.ndarray, error: np.ndarray) -> tuple[float, float]:
    """Average of ``error`` (N,) weighted by path length, equation (44), and the path length.

    At a point of ``points`` (N, 2) the weight is half the distance to the previous point plus half
    that to the next one; the first and the last point have one neighbour only. The sum is divided
    by the path length. A path of no length has the plain mean.
    """
    chord = np.hypot(*np.diff(points, axis=0).T)
    length = float(chord.sum())
    if length == 0.0:
        return float(error.mean()), 0.0
    weight = 0.5 * (np.append(chord, 0.0) + np.append(0.0, chord))
    return float(weight @ error / length), length


def time_weighted_average(t: np.ndarray, value: np.ndarray) -> float:
    """Average of ``value`` (N,) over time, equations (45) and (46).

    The weight at ``t_k`` [s] is half of ``t_{k+1} - t_{k-1}``; the first and the last instant have
    one neighbour only.
    """
    span = float(t[-1] - t[0])
    if span == 0.0:
        return float(value.mean())
    gap = np.diff(t)
    weight = 0.5 * (np.append(gap, 0.0) + np.append(0.0, gap))
    return float(weight @ value / span)


def differences(t: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Magnitude of the backward difference quotient of ``vectors`` (N, d); 0 at the first instant.

    The jerk of the thesis is one of acceleration; how it was differenced is not printed.
    """
    rate = np.linalg.norm(np.diff(vectors, axis=0), axis=1) / np.diff(t)
    return np.append(0.0, rate)


def instants(t_end: float, step: float) -> np.ndarray:
    """``k * step`` up to the end [s].

    Parameters
    ----------
    t_end, step : float
        [s].

    Returns
    -------
    ndarray (N,)
        From 0; the end itself only where it is a multiple of the step.
    """
    return np.minimum(np.arange(int(t_end / step + 1e-9) + 1) * step, t_end)


def measures(trajectory: Trajectory, step: float = 1e-3) -> Metrics:
    """Measure a run.

    Parameters
    ----------
    trajectory : Trajectory
    step : float
        Sampling step of the thesis's measures [s]: instants ``k * step`` (its own is not printed;
        at a transition the value after it counts).

    Raises
    ------
    ValueError
        If ``step`` is not a positive number.
    """
    if not step > 0.0:
        raise ValueError(f"the sampling step is {step} s; it has to be greater than 0 s")
    t_end = trajectory.t_end
    both = sample(trajectory, *output_grid(trajectory, step))
    uniform = _among(both, trajectory, instants(t_end, step))
    size = np.linalg.norm(uniform.acceleration, axis=1)
    jerk = differences(uniform.t, uniform.acceleration)
    counted = transitions(trajectory)
    variation = total_variation(trajectory)
    return Metrics(
        step=step,
        run_time=t_end,
        **path_measures(trajectory.scenario, uniform.tip),
        average_acceleration=time_weighted_average(uniform.t, size),
        max_acceleration=float(np.linalg.norm(both.acceleration, axis=1).max()),
        average_jerk=time_weighted_average(uniform.t, jerk),
        max_jerk=float(jerk.max()),
        variation_smooth=variation.rate_smooth,
        variation_jumps=variation.rate_jumps,
        flat_portions=counted.counts,
        transitions=counted.total,
        reversals=counted.reversals,
        torque_following=torque_following(both),
        saturation_time=saturation_time(trajectory),
        energy_from_user=float(both.work_load[-1]),
        energy_given_back=given_back(trajectory),
        device=trajectory.scenario.device,
    )


def given_back(trajectory: Trajectory) -> float:
    """What the loads take back while they do work in all [J], from eight parts of every step.

    The parts are the solver's own, so that the measure depends on no output grid.
    """
    starts = trajectory.step_t
    if len(starts) == 0:
        return 0.0
    length = np.diff(np.append(starts, trajectory.t_end))
    times = (starts[:, None] + length[:, None] * np.arange(PARTS) / PARTS).ravel()
    z = trajectory.scenario.sizes()
    at = 2 * z["n"] + z["m"] + z["nz"]
    work = states(trajectory, times, np.repeat(trajectory.step_segment, PARTS))[:, at]
    return float(np.maximum(-np.diff(np.append(work, trajectory.end[at])), 0.0).sum())


def _among(samples: Samples, trajectory: Trajectory, times: np.ndarray) -> Samples:
    """``sample(trajectory, times)``, from ``samples`` if all are among them (rounding may part)."""
    right = np.flatnonzero(samples.side == "right")
    found = np.searchsorted(samples.t[right], times)
    rows = right[np.minimum(found, right.size - 1)] if right.size else found
    there = right.size > 0 and bool((samples.t[rows] == times).all())
    return samples.rows(rows) if there else sample(trajectory, times)


def path_measures(scenario, points: np.ndarray | None) -> dict[str, float | None]:
    """Errors and length [m] of a path through points (N, 2); None where there is no tip, no line.

    Parameters
    ----------
    scenario : Scenario
        Which may have a desired path.
    points : ndarray, (N, 2), or None
        Of the tip [m].
    """
    path = desired_path(scenario)
    if points is None:
        return {"average_error": None, "max_error": None, "path_length": None}
    error = np.zeros(len(points)) if path is None else abs(path.offset(points))
    average, length = path_weighted_average(points, error)
    return {
        "average_error": None if path is None else average,
        "max_error": None if path is None else float(error.max()),
        "path_length": length,
    }


def torque_following(samples: Samples) -> tuple[float, ...] | None:
    """Root mean square over time of ``|tau_i| - |desired_i|`` [N m or N], per clutch; None without.

    Desired torques are the held inputs ``desired_1`` ... While a clutch is stuck its torque is what
    the motion asks for; where it is not unique, it is the sharing convention's.
    """
    m = samples.tau.shape[1]
    if m == 0 or not all(f"desired_{i + 1}" in samples.held for i in range(m)):
        return None
    desired = np.column_stack([samples.held[f"desired_{i + 1}"] for i in range(m)])
    square = (abs(samples.tau) - abs(desired)) ** 2
    return tuple(float(np.sqrt(time_weighted_average(samples.t, row))) for row in square.T)


def saturation_time(trajectory: Trajectory) -> tuple[float, ...]:
    """How long each clutch's command was at its full scale or beyond [s]; (m,)."""
    length = np.diff(trajectory.segment_t, axis=1)[:, 0]
    scale = [clutch.full_scale for clutch in trajectory.scenario.clutches]
    full = trajectory.held[:, : len(scale)] >= np.array(scale)
    return tuple(float(value) for value in length @ full)
