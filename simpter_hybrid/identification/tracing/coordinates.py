"""Coordinates on which a residual may depend, computed from the record and the prediction."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from ..recordings.row_step import row_step
from ..recordings.smoothing import derivative, smoothed

#: Window over which measured speeds are smoothed [s].
SMOOTHING = 0.03
#: Memory of the dissipated energy [s].
HEAT_MEMORY = 5.0
#: Half-width of the play that tells rising from falling excitation, relative to its largest value.
PLAY = 0.15


def coordinates(
    time: np.ndarray,
    position: np.ndarray,
    speed: np.ndarray,
    torque: np.ndarray,
    excitation: np.ndarray,
    others: Mapping[str, np.ndarray] | None = None,
    turn: float = 2 * np.pi,
    since: tuple[float, float, float] | None = None,
) -> dict[str, np.ndarray]:
    """Everything a friction, actuator or load effect may depend on, one array each (samples,).

    Parameters
    ----------
    time, position, speed, torque, excitation : ndarray (samples,)
        Position as measured; speed, transmitted torque and excitation as predicted [SI]: in a
        balance a measured speed would correlate with its own noise.
    others : mapping, optional
        Further channels taken as they are, e.g. a neighbour's command.
    turn : float
        Period of the position [rad]; inf for a straight axis, 0 where nobody knows the place, which
        is none of the coordinates then.
    since : tuple of float, optional
        Of a piece of a run: how long that had gone on [s], its way and its heat when it began.
    """
    step = row_step(time)
    v = smoothed(speed, step, SMOOTHING)
    moving = np.abs(v) > 0.02 * max(float(np.abs(v).max()), 1e-12)
    way = np.cumsum(np.abs(v)) * step
    reversal = _at_last_change(np.where(moving, np.sign(v), 0.0), way)
    power = np.abs(torque * v)
    found = {
        "slip_velocity": v,
        "speed": np.abs(v),
        "direction": np.where(moving, np.sign(v), 0.0),
        "position": np.mod(position, turn) if 0.0 < turn < np.inf else position,
        "excitation": excitation,
        "excitation_rate": derivative(excitation, step, SMOOTHING),
        "excitation_branch": excitation - play(excitation, PLAY * _span(excitation)),
        "torque": np.abs(torque),
        "displacement_since_reversal": way - reversal,
        "distance": way,
        "heat": leaky_integral(power, step, HEAT_MEMORY),
        "time": time - time[0],
        "acceleration": derivative(v, step, SMOOTHING),
    }
    found.update(others or {})
    if since:
        later, way_before, warmed = since
        found["time"] += later
        found["distance"] += way_before
        found["heat"] += warmed * np.exp((time[0] - time) / HEAT_MEMORY)
    return found if turn > 0.0 else {name: x for name, x in found.items() if name != "position"}


def carried_on(
    time: np.ndarray, speed: np.ndarray, torque: np.ndarray
) -> tuple[float, float, float] | None:
    """Time, way and heat up to the end of what was before a piece; None of what has no rows.

    Parameters
    ----------
    time, speed, torque : ndarray (samples,)
        [SI]
    """
    if time.size < 2:
        return None
    step = row_step(time)
    v = smoothed(speed, step, SMOOTHING)
    heat = leaky_integral(np.abs(torque * v), step, HEAT_MEMORY)
    return float(time[-1] - time[0]) + step, float(np.abs(v).sum()) * step, float(heat[-1])


def turn_of(positions: Iterable[np.ndarray]) -> float:
    """Period of an angle of which these are all fitted runs [rad].

    A turn where they go beyond one, else inf: a joint that swings to and fro about 0 would lie at
    both ends of a turn.
    """
    runs = [run for run in positions if run.size]
    low, high = min(float(r.min()) for r in runs), max(float(r.max()) for r in runs)
    return 2 * np.pi if high - low > 2 * np.pi else np.inf


def since_rest(time: np.ndarray, speed: np.ndarray) -> np.ndarray:
    """Time since the predicted speed was last exactly 0, i.e. since the last breakaway [s]."""
    at_rest = np.flatnonzero(speed == 0.0)
    last = np.zeros(time.size, int)
    last[at_rest] = at_rest
    return time - time[np.maximum.accumulate(last)]


def since_turn(position: np.ndarray, resolved: float) -> np.ndarray:
    """Way from where a recorded motion last turned round (samples,), positive.

    Unlike a predicted one it tells what happens while the model sticks at a reversal.

    Parameters
    ----------
    position : ndarray (samples,)
        As measured.
    resolved : float
        Least way back that is no noise.
    """
    out = np.empty(position.size)
    turn = far = float(position[0]) if position.size else 0.0
    sign, farthest = 0, 0
    for k, x in enumerate(position.tolist()):
        ahead = sign * (x - far)
        if ahead >= 0.0 and sign:
            far, farthest = x, k
        elif abs(x - far) > resolved:
            turn = far
            out[farthest:k] = np.abs(position[farthest:k] - turn)
            sign, far, farthest = (1 if x > far else -1), x, k
        out[k] = abs(x - turn)
    return out


def play(values: np.ndarray, half_width: float) -> np.ndarray:
    """Output of a play of the given half-width that starts at rest at the first value."""
    out = np.empty(values.size)
    at = float(values[0]) if values.size else 0.0
    for k, value in enumerate(values.tolist()):
        at = min(max(at, value - half_width), value + half_width)
        out[k] = at
    return out


def leaky_integral(values: np.ndarray, step: float, memory: float) -> np.ndarray:
    """Integral of `values` that forgets with the time constant `memory` [s]."""
    from scipy.signal import lfilter

    fade = np.exp(-step / memory)
    return lfilter([step], [1.0, -fade], values)


def _at_last_change(sign: np.ndarray, values: np.ndarray) -> np.ndarray:
    """For every sample, `values` at the last sample at which a nonzero sign changed."""
    nonzero = np.flatnonzero(sign)
    if nonzero.size == 0:
        return np.zeros(sign.size)
    last = np.maximum.accumulate(np.where(sign != 0, np.arange(sign.size), nonzero[0]))
    filled = sign[last]
    changed = np.flatnonzero(np.diff(filled) != 0) + 1
    index = np.zeros(sign.size, int)
    index[changed] = changed
    return values[np.maximum.accumulate(index)]


def _span(values: np.ndarray) -> float:
    return float(values.max() - values.min()) if values.size else 0.0
