"""Motion of the rotor in one step of 50 us, and a whole run row by row."""

from __future__ import annotations

import math

import numpy as np
from own_testbed_physics import (
    AGE,
    ANGLE,
    BRISTLE,
    CARRIED,
    DRIVE,
    EVENTS,
    FAST,
    GAP,
    INTEGRAL,
    LAGGED,
    NEED,
    PATH,
    READ,
    SAMPLES,
    SINCE,
    SLOPE,
    SLOW,
    SPEED,
    SPRING,
    STATES,
    STEP,
    STEPS,
    STUCK,
    TIME,
    TORQUE,
    WAY,
    WORK,
    YIELDS,
    Numbers,
    break_torque,
    common_factor,
    excite,
    load_torque,
    magnetised,
    njit,
    slip_factor,
    slip_map,
)

#: Gain [lbf in s], growth of the integral a sample, and limit of the speed servo [lbf in].
GAIN, GROWTH, LIMIT = 800.0, 60.0, 900.0


@njit(cache=True)
def slip_torque(s, speed, u, way, n):
    """Torque of a sliding clutch; never negative."""
    factor = common_factor(s, u, way, n) * slip_factor(s, speed, n)
    return max(0.0, factor) * slip_map(speed, u, n)


@njit(cache=True)
def stand(s, motor, u, chance, n):
    """At rest: hold, or let go."""
    need = motor + load_torque(s, 0.0, n)
    way = 1.0 if need > 0.0 else -1.0
    if n.by_slope != 0.0:
        s[SLOPE] += ((abs(need) - s[NEED]) / STEP - s[SLOPE]) * STEP / 0.005
        s[NEED] = abs(need)
    if abs(need) <= break_torque(s, u, way, chance, n):
        s[TORQUE] = need
        s[AGE] += STEP
        return
    s[STUCK], s[SINCE], s[AGE], s[WAY] = 0.0, 0.0, 0.0, way
    s[EVENTS] += 1.0


@njit(cache=True)
def slide(s, motor, u, chance, n):
    """One step of Heun's rule; at rest within the step: stand, or turn round."""
    way, speed = s[WAY], s[SPEED]
    first = motor + load_torque(s, speed, n) - way * slip_torque(s, abs(speed), u, way, n)
    ahead = speed + STEP * first / n.inertia
    last = slip_torque(s, max(way * ahead, 0.0), u, way, n)
    second = motor + load_torque(s, ahead, n) - way * last
    after = speed + 0.5 * STEP * (first + second) / n.inertia
    s[TORQUE] = way * last
    if way * after > 0.0:
        s[ANGLE] += 0.5 * STEP * (speed + after)
        s[SPEED] = after
        return
    part = speed / (speed - after) if speed != after else 0.0
    s[ANGLE] += 0.5 * part * STEP * speed
    s[SPEED] = 0.0
    need = motor + load_torque(s, 0.0, n)
    if abs(need) <= break_torque(s, u, 1.0 if need > 0.0 else -1.0, chance, n):
        s[STUCK], s[TORQUE] = 1.0, need
    else:
        s[WAY] = 1.0 if need > 0.0 else -1.0
        s[SINCE] = 0.0


@njit(cache=True)
def bristles(s, motor, u, n):
    """Presliding: torque builds up over a displacement (Dahl's rule with an exponent)."""
    speed = s[SPEED]
    way = 1.0 if speed >= 0.0 else -1.0
    level = slip_torque(s, abs(speed), u, way, n)
    top = break_torque(s, u, way, 0.0, n)
    level += max(0.0, top - level) * math.exp(-((speed / 0.02) ** 2))
    z = s[BRISTLE]
    toward = 1.0 if z * speed >= 0.0 else -1.0
    rate = speed / n.displacement * (1.0 - toward * abs(z) ** 1.3)
    s[TORQUE] = level * (z + 1.5e-3 * rate)
    s[BRISTLE] = min(max(z + STEP * rate, -1.0), 1.0)
    s[SPEED] += STEP * (motor + load_torque(s, speed, n) - s[TORQUE]) / n.inertia
    s[ANGLE] += STEP * s[SPEED]


@njit(cache=True)
def springs(s, motor, u, n):
    """Presliding: springs of fixed stiffness that yield in turn and, slow, hold more."""
    speed = s[SPEED]
    way = 1.0 if speed >= 0.0 else -1.0
    level = slip_torque(s, abs(speed), u, way, n)
    top = break_torque(s, u, way, 0.0, n)
    level += max(0.0, top - level) / (1.0 + (speed / 0.02) ** 8)
    torque = 0.0
    for k in range(len(CARRIED)):
        stiffness = CARRIED[k] * 150.0 / (YIELDS[k] * n.give)
        most = CARRIED[k] * level
        wound = s[SPRING + k] + stiffness * STEP * speed
        s[SPRING + k] = min(max(wound, -most), most)
        damped = s[SPRING + k] + 1.2e-3 * stiffness * speed
        torque += min(max(damped, -most), most)
    s[TORQUE] = torque
    s[SPEED] += STEP * (motor + load_torque(s, speed, n) - torque) / n.inertia
    s[ANGLE] += STEP * s[SPEED]


@njit(cache=True)
def free(s, motor, n):
    """Within a backlash nothing but motor and load acts on the rotor."""
    net = motor + load_torque(s, s[SPEED], n)
    s[SPEED] += STEP * net / n.inertia
    s[ANGLE] += STEP * s[SPEED]
    s[GAP] += STEP * s[SPEED]
    s[TORQUE] = 0.0
    if abs(s[GAP]) >= 0.5 * n.backlash:
        s[GAP] = math.copysign(0.5 * n.backlash, s[GAP])
        s[WAY], s[STUCK] = math.copysign(1.0, s[GAP]), 0.0


@njit(cache=True)
def move(s, motor, u, chance, n):
    """One step of the rotor."""
    if n.displacement > 0.0:
        bristles(s, motor, u, n)
    elif n.give > 0.0:
        springs(s, motor, u, n)
    elif n.backlash > 0.0 and abs(s[GAP]) < 0.5 * n.backlash:
        free(s, motor, n)
    elif s[STUCK] > 0.5:
        stand(s, motor, u, chance, n)
    else:
        slide(s, motor, u, chance, n)
    if n.backlash > 0.0 and s[SPEED] == 0.0 and s[GAP] * (motor + load_torque(s, 0.0, n)) < 0.0:
        s[GAP] *= 1.0 - 1e-9  # the flank is left


@njit(cache=True)
def remember(s, n):
    """What friction keeps in mind: heat, work, path, speed a moment ago."""
    speed = abs(s[SPEED])
    power = abs(s[TORQUE]) * speed
    s[FAST] += STEP * (power / (450.0 * n.cool_fast) - s[FAST] / n.cool_fast)
    s[SLOW] += STEP * (power / (450.0 * 0.4 * n.cool_slow) - s[SLOW] / n.cool_slow)
    s[WORK] += STEP * power
    s[PATH] += STEP * speed
    s[SINCE] += STEP
    s[TIME] += STEP
    s[LAGGED] += (s[SPEED] - s[LAGGED]) * STEP / 0.02
    if n.slow > 0.0:
        s[READ] += (s[TORQUE] - s[READ]) * STEP / n.slow
    else:
        s[READ] = s[TORQUE]


@njit(cache=True)
def march(torque_mode, reference, command, neighbour, chances, n):
    """A whole run.

    Returns
    -------
    ndarray, shape (rows, 4)
        Motor torque, clutch torque as read, speed, angle at the end of each row.
    """
    s = np.zeros(STATES)
    s[STUCK], s[SINCE], s[WAY] = 1.0, 10.0, 1.0
    out = np.empty((len(reference), 4))
    for row in range(len(reference)):
        for _ in range(SAMPLES):
            s[DRIVE] = reference[row]
            if not torque_mode:
                error = reference[row] - s[SPEED]
                s[INTEGRAL] = min(max(s[INTEGRAL] + GROWTH * error, -LIMIT), LIMIT)
                s[DRIVE] = min(max(GAIN * error + s[INTEGRAL], -LIMIT), LIMIT)
            for _ in range(STEPS):
                excite(s, command[row], neighbour[row], n)
                u = magnetised(s, n)
                chance = chances[int(s[EVENTS]) % len(chances)]
                move(s, s[DRIVE], u, chance, n)
                remember(s, n)
        out[row, 0] = (1.0 + n.motor_gain) * s[DRIVE] + n.motor_zero
        out[row, 1] = (1.0 + n.gain) * s[READ] + n.zero
        out[row, 2], out[row, 3] = s[SPEED], s[ANGLE]
    return out


def run(torque_mode, reference, command, neighbour, chances, numbers: Numbers) -> np.ndarray:
    """`march` with arrays made of whatever is given; no scatter where `chances` is empty."""
    given = [np.asarray(x, dtype=float) for x in (reference, command, neighbour)]
    drawn = np.asarray(chances if len(chances) else [0.0], dtype=float)
    return march(bool(torque_mode), *given, drawn, numbers)
