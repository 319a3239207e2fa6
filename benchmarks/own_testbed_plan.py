"""The eleven runs of a testbed battery as the practice recordings have them, and poor ones."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

#: Time between rows [s].
ROW = 2e-3


class Planned(NamedTuple):
    """Commands of a run, held over each row."""

    torque_mode: bool
    reference: np.ndarray
    command: np.ndarray
    neighbour: np.ndarray


def battery(rng: np.random.Generator) -> list[Planned]:
    """One draw of the eleven runs."""
    return [
        pulses(0.394, rng),
        pulses(1.59, rng),
        sines(1.8, [drawn(rng, 3.0, 4.0), drawn(rng, 6.0, 7.0)]),
        sines(0.35, [drawn(rng, 4.0, 6.0)] * 2),
        stairs(rng),
        heat_and_probe(rng),
        there_and_back(rng),
        ramps_of_torque(rng),
        spins(rng),
        dwells(rng),
        neighbour_steps(rng),
    ]


def poor_battery(rng: np.random.Generator) -> list[Planned]:
    """Thesis chapter 4: six constant speeds with a rising and falling command, four steps."""
    runs = []
    for speed in (0.2, 0.4, 0.8, 1.2, 1.6, 2.0):
        top = drawn(rng, 7.0, 9.5)
        command = lines([(0.3, 0.0), (4.0, top), (4.3, top), (8.0, 0.0), (8.3, 0.0)])
        runs.append(servo(speed * rng.uniform(0.95, 1.05), command))
    for low, high in ((0.0, 4.0), (0.0, 7.0), (3.0, 7.0), (7.0, 3.0)):
        f, speed = rng.uniform(0.9, 1.1), drawn(rng, 0.7, 0.9)
        runs.append(servo(speed, steps([(1.5, f * low), (3.0, f * high)] * 2, cyclic=1.5)))
    return runs


def drawn(rng: np.random.Generator, low: float, high: float) -> float:
    """A setting as somebody would type it."""
    return float(f"{rng.uniform(low, high):.4g}")


def steps(levels, cyclic: float = 0.0) -> np.ndarray:
    """Levels (end [s], value) one after the other; `cyclic`: each lasts that long instead."""
    if cyclic:
        levels = [((k + 1) * cyclic, value) for k, (_, value) in enumerate(levels)]
    out, begin = [], 0
    for end, value in levels:
        out.append(np.full(round(end / ROW) - begin, float(value)))
        begin = round(end / ROW)
    return np.concatenate(out)


def lines(corners) -> np.ndarray:
    """Straight lines between corners (time [s], value), from 0 at 0."""
    time = ROW * np.arange(round(corners[-1][0] / ROW))
    at, value = zip(*[(0.0, corners[0][1]), *corners], strict=True)
    return np.interp(time, at, value)


def servo(speed, command, neighbour=0.0) -> Planned:
    """Speed servo; what is a number holds throughout."""
    return _planned(False, speed, command, neighbour)


def _planned(torque_mode, *inputs) -> Planned:
    size = max(np.size(x) for x in inputs)
    return Planned(torque_mode, *(np.array(np.broadcast_to(x, size), dtype=float) for x in inputs))


def pulses(speed: float, rng: np.random.Generator) -> Planned:
    """Steps of command from zero and from a held level at constant speed."""
    a, b, c, d = rng.permutation([3.0, 5.0, 6.5, 8.0]) + rng.uniform(-0.4, 0.4, 4)
    low, top = drawn(rng, 1.8, 2.4), drawn(rng, 7.6, 8.4)
    levels = [(0.4, 0), (0.9, a), (1.5, 0), (2.0, b), (2.6, 0), (3.05, c), (3.65, 0)]
    levels += [(4.15, low), (4.65, d), (5.15, low), (5.65, top), (6.25, 0)]
    return servo(speed, steps(levels))


def sines(amplitude: float, commands) -> Planned:
    """Two periods of a sine of speed, a command each."""
    time = ROW * np.arange(round(10.3 / ROW))
    speed = np.where(time < 0.3, 0.0, amplitude * np.sin(2 * np.pi / 5.0 * (time - 0.3)))
    return servo(speed, steps([(5.3, commands[0]), (10.3, commands[1])]))


def stairs(rng: np.random.Generator) -> Planned:
    """A command that rises and falls with minor loops."""
    top = drawn(rng, 8.5, 9.5)
    corners = [(0.3, 0.2), (2.8, top), (3.1, top), (5.6, 0.6), (6.8, 5), (7.7, 2), (8.9, 7)]
    command = lines([*corners, (9.7, 4), (10.3, 6), (11.8, 0.2), (12.3, 0.2)])
    time = ROW * np.arange(command.size)
    return servo(drawn(rng, 0.7, 1.0), np.where((time < 0.3) | (time >= 11.8), 0.0, command))


def heat_and_probe(rng: np.random.Generator) -> Planned:
    """Fast sliding at a high command between probes."""
    ends = (1.5, 10.5, 12.0, 17.0, 18.5)
    speed = steps(list(zip(ends, (0.8, 2.0, 0.8, 0.3, 0.8), strict=True)))
    command = zip(ends, (4.0, drawn(rng, 6.0, 7.0), 4.0, 1.5, 4.0), strict=True)
    return servo(speed, steps(list(command)))


def there_and_back(rng: np.random.Generator) -> Planned:
    """2.2 turns one way, then back."""
    speed = drawn(rng, 1.1, 1.4)
    turn = round(2.2 * 2 * np.pi / speed / ROW) * ROW
    return servo(steps([(turn, speed), (2 * turn, -speed)]), drawn(rng, 4.1, 5.9))


def declared_breakaway(command: float) -> float:
    """Equation (43) [lbf in]."""
    return 6.648 * command**2 + 6.176 * command + 5.253


def ramps_of_torque(rng: np.random.Generator) -> Planned:
    """Torque rises beyond breakaway, both ways, at three commands."""
    torque, command = [], []
    for middle in (3.0, 5.0, 7.0):
        volts = drawn(rng, middle - 0.4, middle + 0.4)
        peak = 1.06 * declared_breakaway(volts)
        corners = [(1.6, peak), (1.85, 0), (2.35, 0), (3.95, -peak), (4.2, 0), (4.7, 0)]
        torque.append(lines([(0.0, 0.0), *corners]))
        command.append(np.full(round(4.7 / ROW), volts))
    return _planned(True, np.concatenate(torque), np.concatenate(command), 0.0)


def spins(rng: np.random.Generator) -> Planned:
    """Clutch off: pushed, coasting, stopped, both ways."""
    torque = []
    for k in range(8):
        push, hold, coast = rng.uniform(7, 14), rng.uniform(0.15, 0.3), rng.uniform(0.4, 0.9)
        push *= (-1) ** k
        times = np.cumsum([hold, coast, 0.9 * hold, 0.35])
        torque.append(steps(list(zip(times, (push, 0.0, -0.9 * push, 0.0), strict=True))))
    return _planned(True, np.concatenate(torque), 0.0, 0.0)


def dwells(rng: np.random.Generator) -> Planned:
    """Short ramps of torque to breakaway after rests of 0.35 to 4.75 s."""
    volts = drawn(rng, 3.5, 4.4)
    peak = 1.06 * declared_breakaway(volts)
    rests = rng.permutation([0.35, 0.35, 0.55, 0.55, 1.25, 1.25, 2.75, 4.75])
    rests[0] -= 0.25
    ramp = peak * np.arange(round(0.4 / ROW)) / round(0.4 / ROW)
    torque = [np.concatenate([np.zeros(round(rest / ROW)), ramp]) for rest in rests]
    whole = np.concatenate([*torque, np.zeros(round(0.25 / ROW))])
    return _planned(True, whole, volts, 0.0)


def neighbour_steps(rng: np.random.Generator) -> Planned:
    """Steps of the second clutch's command."""
    ends, volts = (1, 2, 3, 4, 4.6, 5.4, 6.4, 7), (0, 8, 0, 5, 0, 7, 3, 0)
    neighbour = steps(list(zip(ends, volts, strict=True)))
    return servo(drawn(rng, 0.6, 0.95), drawn(rng, 3.5, 4.5), neighbour)
