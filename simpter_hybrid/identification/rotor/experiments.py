"""Experiments that a rotor with a clutch can do: from these the next run is recommended.

Both torques are logged in all of them.  Each shows a kind of effect that others confuse: the open
clutch shows load and inertia, a bidirectional sine direction and speed, stairs with minor loops
hysteresis, speeds one after the other heat against wear, steps the supply and the pull-in, ramps of
torque after rests breakaway, steps of a second clutch the coupling.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..fitting.replay import Observation, Replay
from .signals import RotorSignals

#: Time between samples [s].
STEP = 2e-3


@dataclass(frozen=True)
class Reach:
    """How far an experimenter has gone, taken from the runs that were made.

    Parameters
    ----------
    speed : float
        [rad/s]
    command : float
        [V]
    torque : float
        Transmitted [N*m].
    sd : mapping of str to float
        Noise of clutch torque, motor torque [N*m] and speed [rad/s].
    """

    speed: float
    command: float
    torque: float
    sd: Mapping[str, float]


def reach_of(replays: Sequence[Replay], signals: RotorSignals) -> Reach:
    """How far recorded runs went; a torque that was not logged would be as noisy as the other.

    Speeds are those of servo runs, where there are any: a torque may run away with a rotor.
    """
    held = [r for r in replays if signals.speed not in r.observed] or replays
    speed = max(float(np.quantile(np.abs(r.notes[signals.speed]), 0.99)) for r in held)
    command = max(float(r.inputs[signals.command].max()) for r in replays)
    carried = [np.abs(r.observed[signals.transmitted].values) for r in replays]
    sd = {c: o.sd for r in replays for c, o in r.observed.items()}
    sd.setdefault(signals.applied, sd[signals.transmitted])
    sd.setdefault(signals.speed, 0.01 * speed)
    return Reach(speed, command, max(float(np.quantile(c, 0.99)) for c in carried), sd)


def rotor_experiments(reach: Reach, coupled: bool = True) -> list[Replay]:
    """The experiments as runs without measured values; `coupled`: there is a second clutch."""
    v, u = reach.speed, reach.command
    found = [
        _servo(reach, "clutch off, speed in steps both ways",
               _stairs([v / 2, v, -v, -v / 2], 1.5), 0.0),
        _servo(reach, "speed sine both ways, two commands",
               _sine(v, 4.0, 10.0), _stairs([0.4 * u, 0.7 * u], 5.0)),
        _servo(reach, "slow speed sine both ways, constant command",
               _sine(v / 6, 5.0, 10.0), 0.5 * u),
        _servo(reach, "speed in steps up, down and back, constant command",
               _stairs([v, v / 4, v / 16, v / 4, v, -v, -v / 16], 1.5), 0.5 * u),
        _servo(reach, "slow, fast and slow again for long, constant command",
               _stairs([v / 6, v, v / 6], 6.0), 0.6 * u),
        _servo(reach, "command stairs with minor loops, constant speed", 0.4 * v,
               _ramp(u, [0.3, 0.9, 0.5, 0.8, 0.2, 1.0, 0.0, 0.6, 0.0], 1.2)),
        _servo(reach, "command steps from zero and from held levels, constant speed", 0.4 * v,
               _stairs([0, 0.4 * u, 0, 0.8 * u, 0.4 * u, 0.8 * u, 0, 0.1 * u, 0], 0.8)),
        _ramps(reach, "torque ramps to breakaway after short and long rests, both ways"),
        _servo(reach, "steps of the second clutch, constant speed and command", 0.5 * v, 0.5 * u,
               _stairs([0, u, 0, u / 2, 0], 1.4)),
    ]  # fmt: skip
    return found if coupled else found[:-1]


def _servo(reach: Reach, name: str, speed, command, neighbour=0.0) -> Replay:
    given = [np.atleast_1d(np.asarray(x, dtype=float)) for x in (speed, command, neighbour)]
    size = max(x.size for x in given)
    filled = [np.concatenate([x, np.full(size - x.size, x[-1])]) for x in given]
    inputs = {
        "reference_speed": filled[0], "command": filled[1], "neighbour_command": filled[2],
        "reference_torque": np.zeros(size), "servo_mode": np.zeros(size),
    }  # fmt: skip
    return _replay(reach, name, inputs, ("clutch_torque", "motor_torque"))


def _ramps(reach: Reach, name: str) -> Replay:
    """Rests of 0.2 to 3 s, each ended by a ramp that breaks away and falls at once."""
    torque = []
    for k, rest in enumerate((0.2, 3.0, 0.6, 1.5)):
        rise = np.linspace(0.0, 0.8 * reach.torque, round(1.0 / STEP))
        torque += [np.zeros(round(rest / STEP)), (-1) ** k * rise]
    reference = np.concatenate(torque)
    inputs = {
        "reference_torque": reference, "command": np.full(reference.size, 0.6 * reach.command),
        "neighbour_command": np.zeros(reference.size), "servo_mode": np.ones(reference.size),
        "reference_speed": np.zeros(reference.size),
    }  # fmt: skip
    return _replay(reach, name, inputs, ("clutch_torque", "speed"))


def _replay(reach: Reach, name: str, inputs, channels: tuple[str, ...]) -> Replay:
    size = inputs["command"].size
    every, nothing = np.ones(size, bool), np.zeros(size)
    observed = {c: Observation(nothing, reach.sd[c], every) for c in channels}
    time = STEP * np.arange(1, size + 1)
    notes = {"position": nothing, "speed": nothing}
    return Replay(name, name, time, inputs, observed, notes=notes, laid_down=inputs)


def _stairs(levels: Sequence[float], each: float) -> np.ndarray:
    return np.repeat(np.asarray(levels, dtype=float), round(each / STEP))


def _ramp(top: float, corners: Sequence[float], each: float) -> np.ndarray:
    count = round(each / STEP)
    at = np.arange(count * (len(corners) - 1)) / count
    return top * np.interp(at, np.arange(len(corners)), corners)


def _sine(amplitude: float, period: float, duration: float) -> np.ndarray:
    return amplitude * np.sin(2 * np.pi / period * STEP * np.arange(round(duration / STEP)))
