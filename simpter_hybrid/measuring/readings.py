"""What instruments would have read of a run: chosen signals through sensors, at one rate."""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np

from ..device import Device
from ..sensor import Sensor, differentiated
from ..trajectory import Trajectory
from ..units import si_unit
from .over_poses import over_poses
from .samples import Samples
from .sampling import sample

#: Axes of a sensor of a tip's force that has neither a turn nor cross-talk.
AS_IT_IS = np.eye(2)


class Signal(NamedTuple):
    """What a sensor may be put on: its dimension, and its column of a run's samples."""

    dimension: str
    column: Callable[[Samples], np.ndarray]


@dataclass(frozen=True)
class Channel:
    """One column of the readings.

    Parameters
    ----------
    signal : str
        A key of ``signals``.
    sensor : Sensor
    differentiated : bool
        Speed from differences of the readings, as of a potentiometer.
    speed_filter : float
        Time constant of a first-order filter behind the differences [s].
    """

    signal: str
    sensor: Sensor
    differentiated: bool = False
    speed_filter: float = 0.0


@dataclass(frozen=True)
class Readings:
    """Channels that are read every ``period``.

    Parameters
    ----------
    period : float
        [s].
    channels : tuple of Channel
    force_turned : float
        The sensor of a tip's force shows it turned by this angle, anticlockwise [rad].
    force_crosstalk : tuple of two floats
        Part of the force along y that this sensor shows along x as well, and of that along x along
        y (behind the turn).
    """

    period: float
    channels: tuple[Channel, ...]
    force_turned: float = 0.0
    force_crosstalk: tuple[float, float] = (0.0, 0.0)

    @property
    def force_axes(self) -> np.ndarray:
        """What the sensor of a tip's force shows of it, before gains: a matrix (2, 2)."""
        return force_axes(self.force_turned, *self.force_crosstalk)


def force_axes(turned: float, x: float = 0.0, y: float = 0.0) -> np.ndarray:
    """What a sensor shows of the force on a tip: turned by an angle [rad], then cross-talk (2, 2).

    ``x`` is the part of the force along y that shows along x, ``y`` of that along x along y.
    """
    c, s = np.cos(turned), np.sin(turned)
    return np.array([[1.0, x], [y, 1.0]]) @ np.array([[c, -s], [s, c]])


def signals(device: Device, force_axes: np.ndarray = AS_IT_IS) -> dict[str, Signal]:
    """Signals of a device by name; the force on its tip as its sensor's axes show it (2, 2)."""
    found: dict[str, Signal] = {}
    kinds = device.coordinate_dimensions or ("angle",) * device.n
    speeds = {"angle": "angular_speed", "length": "speed"}
    forces = {"angle": "torque", "length": "force"}
    for j, (name, kind) in enumerate(zip(device.coordinates, kinds, strict=True)):
        found[name] = Signal(kind, partial(_column, "q", j))
        found[f"speed of {name}"] = Signal(speeds[kind], partial(_column, "qd", j))
        found[f"load on {name}"] = Signal(forces[kind], partial(_column, "load", j))
        found[f"friction on {name}"] = Signal(forces[kind], partial(_friction, device, j))
    along = "length" if device.surface_units[1] == "N" else "angle"
    for i in range(device.m):
        found[f"torque of clutch {i + 1}"] = Signal(forces[along], partial(_column, "tau", i))
        found[f"slip of clutch {i + 1}"] = Signal(speeds[along], partial(_column, "slip", i))
        found[f"excitation of clutch {i + 1}"] = Signal(
            "voltage", partial(_column, "excitation", i)
        )
        found[f"command of clutch {i + 1}"] = Signal("voltage", partial(_command, i))
    if "tip" in device.functions():
        for j, axis in enumerate("xy"):
            found[f"tip {axis}"] = Signal("length", partial(_column, "tip", j))
            found[f"tip force {axis}"] = Signal("force", partial(_tip_force, force_axes[j]))
    return found


def _column(name: str, j: int, samples: Samples) -> np.ndarray:
    return getattr(samples, name)[:, j]


def _tip_force(axis: np.ndarray, samples: Samples) -> np.ndarray:
    return samples.tip_force @ axis


def _friction(device: Device, j: int, samples: Samples) -> np.ndarray:
    """What all clutches together do along a coordinate: column j of C, times their torques."""
    maps = over_poses(device, "clutch_map", samples.q, device.m * device.n)
    return np.sum(maps[:, j :: device.n] * samples.tau, axis=1)


def _command(i: int, samples: Samples) -> np.ndarray:
    return samples.held[f"command_{i + 1}"]


def rate_of(dimension: str) -> str:
    """Dimension of a differentiated signal."""
    return {"angle": "angular_speed", "length": "speed"}.get(dimension, f"{dimension}/time")


def read(trajectory: Trajectory, readings: Readings) -> tuple[np.ndarray, np.ndarray]:
    """Instants by the instruments' clock [s] and readings [SI].

    The same seed gives the same bytes, whatever else is read.

    Returns
    -------
    ndarray, (N,)
    ndarray, (N, channels)
    """
    known = signals(trajectory.scenario.device, readings.force_axes)
    times = np.arange(int(trajectory.t_end / readings.period * (1.0 + 1e-12)) + 1) * readings.period

    @lru_cache(maxsize=8)
    def seen(instants: bytes) -> Samples:
        # Before the run and after it instruments stand where it began and ended.
        return sample(trajectory, np.clip(np.frombuffer(instants), 0.0, trajectory.t_end))

    def at(column: Callable[[Samples], np.ndarray], instants: np.ndarray) -> np.ndarray:
        return column(seen(instants.tobytes()))

    columns = []
    for number, channel in enumerate(readings.channels):
        values = channel.sensor.read(times, partial(at, known[channel.signal].column), number)
        if channel.differentiated:
            values = differentiated(times, values, channel.speed_filter)
        columns.append(values)
    return times, np.column_stack(columns) if columns else np.zeros((len(times), 0))


def readings_csv(trajectory: Trajectory, readings: Readings) -> str:
    """The readings as CSV: names and SI units in the first line."""
    known = signals(trajectory.scenario.device)
    names = ["t [s]"]
    for channel in readings.channels:
        dimension = known[channel.signal].dimension
        made = f"{channel.signal}, differentiated" if channel.differentiated else channel.signal
        unit = si_unit(rate_of(dimension) if channel.differentiated else dimension)
        names.append(f"{made} [{unit}]")
    out = io.StringIO()
    out.write(",".join(f'"{name}"' if "," in name else name for name in names) + "\n")
    times, values = read(trajectory, readings)
    for t, row in zip(times.tolist(), values.tolist(), strict=True):
        out.write(",".join(repr(v) for v in (t, *row)) + "\n")
    return out.getvalue()
