"""One clutch on a motorized testbed, integrated in steps of 50 us: stick is a plain rule here.

Made for recordings that judge `simpter diagnose`; nothing of simpter_hybrid is used.  Units are
those of the recordings: lbf*in, rad, s, V.  A neutral `Numbers` is the declared testbed (thesis
equations (39) and (43)); every effect is a departure of some of its fields.
"""

from __future__ import annotations

import math
from typing import NamedTuple

try:
    from numba import njit
except ImportError:  # a hundred times slower, the same numbers

    def njit(**_):
        """Leave the function as it is."""
        return lambda f: f


#: Step of the integration [s], steps a servo sample, samples a row of the recording.
STEP, STEPS, SAMPLES = 5e-5, 20, 2
PLAYS = 5
(ANGLE, SPEED, EXCITATION, FOLLOWER, CLOCK, ON, STUCK, AGE, WAY, SINCE, FAST, SLOW, WORK, PATH,
 NEIGHBOUR, LAGGED, READ, BRISTLE, GAP, EVENTS, RATE, TORQUE, TIME, INTEGRAL, DRIVE, NEED, SLOPE,
 PLAY) = range(28)  # fmt: skip
#: Springs side by side, in the state after the plays: part of the friction that each carries, and
#: where it yields, in parts of where the last does.
SPRING = PLAY + PLAYS
CARRIED, YIELDS = (0.15, 0.25, 0.25, 0.35), (0.2, 0.45, 0.7, 1.0)
#: Numbers in the state.
STATES = SPRING + len(CARRIED)


class Numbers(NamedTuple):
    """What the rig is; the defaults are what is declared."""

    inertia: float = 0.9
    slip: float = 1.0  # of the slip map, relative
    level: float = 1.0  # of the breakaway map, relative
    slope: float = 1.0  # of the velocity slope, relative
    lag: float = 0.07
    delay: float = 0.02
    # friction
    stribeck: float = 0.0
    stribeck_speed: float = 0.08
    degressive: float = 0.0
    degressive_speed: float = 0.4
    asymmetry: float = 0.0
    once_cos: float = 0.0
    once_sin: float = 0.0
    twice_cos: float = 0.0
    twice_sin: float = 0.0
    thrice: float = 0.0
    fade: float = 0.0
    cool_fast: float = 4.0
    cool_slow: float = 25.0
    warm: float = 0.0
    warm_work: float = 3000.0
    wear: float = 0.0
    wear_path: float = 8.0
    drift: float = 0.0
    dwell: float = 0.0
    by_slope: float = 0.0  # exponent of breakaway by how fast the load rises
    power: float = 0.0  # of the excitation, beyond 1
    displacement: float = 0.0
    give: float = 0.0  # where the last spring yields, at 150 lbf*in [rad]
    # actuator
    play: float = 0.0
    remanence: float = 0.0
    late: float = 0.0
    drop_out: float = 0.0
    slew: float = 0.0  # least time for a volt [s/V]
    release: float = 0.0
    second_lag: float = 0.0
    coupling: float = 0.0
    offset: float = 0.0  # of the command [V]
    # load
    viscous: float = 0.0
    quadratic: float = 0.0
    heavy_cos: float = 0.0
    heavy_sin: float = 0.0
    # sensor of clutch torque
    gain: float = 0.0
    zero: float = 0.0
    slow: float = 0.0
    # sensor of motor torque
    motor_gain: float = 0.0
    motor_zero: float = 0.0
    # in nobody's list
    hidden: float = 0.0
    wander: float = 0.0
    wander_phase: float = 0.0
    same_way: float = 0.0
    squeal: float = 0.0
    squeal_frequency: float = 28.0
    poles: float = 0.0
    inertia_of_friction: float = 0.0
    squeeze: float = 0.0
    backlash: float = 0.0


@njit(cache=True)
def slip_map(speed, volts, n):
    """Equation (39), scaled."""
    return n.slip * (0.154 * n.slope * speed + 0.9409) * (6.439 * volts**2 + 0.137 * volts + 0.371)


@njit(cache=True)
def excite(s, command, neighbour, n):
    """Command to excitation: gate, delay, lag and what a coil and a supply do besides."""
    s[NEIGHBOUR] += (neighbour - s[NEIGHBOUR]) * STEP / 0.05
    before = s[EXCITATION]
    if command <= 0.05:
        s[CLOCK] = 0.0
        if before < 0.05 + n.drop_out:
            s[EXCITATION], s[ON] = 0.0, 0.0
    elif s[ON] < 0.5:
        s[CLOCK] += STEP
        if s[CLOCK] >= n.delay + n.late * (1.5 - command / 10.0) - 0.5 * STEP:
            s[ON] = 1.0
    if s[ON] > 0.5:
        asked = command
        if command > 0.05:
            asked = max(0.0, command + n.offset + n.coupling * s[NEIGHBOUR] ** 1.1)
        rate = (asked - before) / n.lag
        if asked < before:
            rate /= 1.0 + n.release * (1.0 + 0.05 * (before - 4.0))
        if n.slew > 0.0:  # a soft limit: no corner where the supply saturates
            rate /= (1.0 + (abs(rate) * n.slew) ** 6) ** (1.0 / 6.0)
        s[EXCITATION] = before + rate * STEP
    s[RATE] += ((s[EXCITATION] - before) / STEP - s[RATE]) * STEP / 0.005
    if n.second_lag > 0.0:
        s[FOLLOWER] += (s[EXCITATION] - s[FOLLOWER]) * STEP / n.second_lag
    else:
        s[FOLLOWER] = s[EXCITATION]


@njit(cache=True)
def magnetised(s, n):
    """Excitation as the torque sees it: five plays, or one whose width grows with it."""
    u = s[FOLLOWER]
    if s[ON] < 0.5 and s[EXCITATION] == 0.0 and n.second_lag == 0.0:
        u = 0.0
    if n.play > 0.0:
        behind = 0.0
        for k in range(PLAYS):
            half = 0.25 * (k + 1.0) ** 1.4
            s[PLAY + k] = min(max(s[PLAY + k], u - half), u + half)
            behind += (s[PLAY + k] - u) / (k + 1.0)
        u = max(0.0, u + n.play * behind / 2.28 * min(1.0, u))
    if n.remanence > 0.0:
        half = n.remanence * (1.0 + 0.05 * (u - 4.0))
        s[PLAY] = min(max(s[PLAY], u - half), u + half)
        u = max(0.0, s[PLAY])
    if n.power != 0.0 and u > 0.0:  # as declared at 5 V
        u *= (u / 5.0) ** (n.power * (1.0 + 0.03 * (u - 5.0)))
    return u


@njit(cache=True)
def common_factor(s, u, way, n):
    """What multiplies slip and breakaway torque alike."""
    f = 1.0 + n.asymmetry * way * (1.0 + 0.02 * (u - 5.0))
    a = s[ANGLE]
    if n.once_cos != 0.0 or n.once_sin != 0.0 or n.twice_cos != 0.0 or n.twice_sin != 0.0:
        f *= 1.0 + n.once_cos * math.cos(a) + n.once_sin * math.sin(a) + n.thrice * math.cos(3 * a)
        f += n.twice_cos * math.cos(2 * a) + n.twice_sin * math.sin(2 * a)
    if n.fade != 0.0:
        f *= math.exp(-n.fade * (0.75 * s[FAST] + 0.25 * s[SLOW]))
    if n.warm != 0.0:
        f *= 1.0 + n.warm / (1.0 + s[WORK] / n.warm_work) ** 1.5
    if n.wear != 0.0:
        f *= 1.0 + n.wear * (1.0 - math.exp(-((s[PATH] / n.wear_path) ** 0.85)))
    if n.poles != 0.0:
        f *= 1.0 + n.poles * (u / 6.0) ** 2 * math.cos(5.0 * a)
    if n.wander != 0.0:
        f *= 1.0 + n.wander * math.sin(1.1 * s[TIME] + n.wander_phase)
    return f * (1.0 + n.drift * s[TIME] ** 0.9) * (1.0 + n.hidden)


@njit(cache=True)
def slip_factor(s, speed, n):
    """What multiplies the slip torque only."""
    f = 1.0
    if n.stribeck != 0.0:
        f += n.stribeck * math.exp(-((speed / n.stribeck_speed) ** 1.3))
    if n.degressive != 0.0:
        f += n.degressive * (1.0 - 1.0 / (1.0 + (speed / n.degressive_speed) ** 1.2))
    if n.squeal != 0.0 and s[SINCE] < 1.0:
        turn = 2.0 * math.pi * n.squeal_frequency * s[SINCE]
        f += n.squeal * math.exp(-s[SINCE] / 0.15) * math.sin(turn)
    if n.inertia_of_friction != 0.0:
        f += n.inertia_of_friction * math.tanh((speed - abs(s[LAGGED])) / 0.02 / 2.0)
    if n.squeeze != 0.0:
        f += n.squeeze * math.tanh(s[RATE] / 15.0) * min(speed, 2.5)
    return f


@njit(cache=True)
def break_torque(s, u, way, chance, n):
    """Equation (43), scaled; `chance` is the scatter of this rest, relative."""
    f = common_factor(s, u, way, n) * (1.0 + chance)
    if n.dwell != 0.0:
        f *= 1.0 + n.dwell * ((1.0 + s[AGE] / 0.1) ** 0.2 - 1.0)
    if n.by_slope != 0.0:  # at 60 lbf*in/s as declared
        f *= (max(s[SLOPE], 1.0) / 60.0) ** -n.by_slope
    if n.same_way != 0.0 and way == s[WAY]:
        f *= 1.0 - n.same_way
    return f * n.level * (6.648 * u**2 + 6.176 * u + 5.253)


@njit(cache=True)
def load_torque(s, speed, n):
    """What acts on the rotor besides motor and clutch."""
    a = s[ANGLE]
    drag = n.viscous * speed * abs(speed) ** 0.1 if n.viscous != 0.0 else 0.0
    if n.quadratic != 0.0:
        drag += n.quadratic * speed * abs(speed) ** 0.9
    heavy = 0.0
    if n.heavy_cos != 0.0 or n.heavy_sin != 0.0:
        heavy = n.heavy_cos * math.cos(a) + n.heavy_sin * math.sin(a)
        heavy += 0.1 * (n.heavy_cos * math.sin(2 * a) - n.heavy_sin * math.cos(2 * a))
    return heavy - drag
