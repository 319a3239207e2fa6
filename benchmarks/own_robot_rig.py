"""PTER with a hand on its handle, integrated independently: nothing of simpter_hybrid is used.

Time stepping on the level of speeds (Moreau): every `H` seconds the impulses of the engaged
clutches solve a box-constrained problem, breakaway torque for those that stuck, slip torque for
those that slipped.  Thesis equations (1)-(15), (39), (43); units lbf, in, s, rad, V.  The true
effects have richer forms than those a diagnosis tries.
"""

from __future__ import annotations

from typing import NamedTuple

import numba
import numpy as np
from own_robot_step import H, advance, slips

EVERY = 20  # steps between rows: 500 Hz
TICK = 150.0
DURATION = 6.0


class Truth(NamedTuple):
    """What the declared model lacks; all zero: nothing.  Four numbers: of each clutch."""

    scale: np.ndarray
    stribeck: np.ndarray = np.zeros(4)  # rise at 0+, falls as 1/(1 + (w/0.12)^2)
    log_speed: np.ndarray = np.zeros(4)  # times asinh(w/0.04)
    degressive: np.ndarray = np.zeros(4)  # times 1 - exp(-w/0.35)
    asymmetry: np.ndarray = np.zeros(4)  # a little stronger at low excitation
    position: np.ndarray = np.zeros(4)  # once and three times a turn
    fade: np.ndarray = np.zeros(4)  # per 100 lbf in of dissipated energy, cools in 3 s
    wear: np.ndarray = np.zeros(4)  # change when run in, 0.6 rad
    drift: np.ndarray = np.zeros(4)  # 1/s
    dwell: np.ndarray = np.zeros(4)  # breakaway, per decade of rest above 50 ms
    grip: np.ndarray = np.zeros(4)  # share of torque at a tip force of 18 lbf (in no library)
    lag: np.ndarray = np.zeros(4)  # relative change of the time constant
    release: np.ndarray = np.zeros(4)  # the same, falling only
    remanence: np.ndarray = np.zeros(4)  # half width of a play, V
    hysteresis: np.ndarray = np.zeros(4)  # share of the excitation through three plays
    pull_in: np.ndarray = np.zeros(4)  # s, longer for small commands
    slew: np.ndarray = np.zeros(4)  # s/V
    second_lag: np.ndarray = np.zeros(4)  # s
    sag: np.ndarray = np.zeros(4)  # of the supply, per V of the other clutches' excitation
    leak: np.ndarray = np.zeros((4, 4))  # of the second's excitation into the first's coil
    field: np.ndarray = np.zeros((4, 4))  # of the second's excitation in the first's gap
    command: np.ndarray = np.zeros(4)  # gain of the supply, with a bend
    offset: np.ndarray = np.zeros(4)  # V
    viscous: np.ndarray = np.zeros(2)  # lbf in s, with a cubic part
    quadratic: np.ndarray = np.zeros(2)
    dry: np.ndarray = np.zeros(2)
    bias: np.ndarray = np.zeros(2)
    tilt: np.ndarray = np.zeros(2)  # weight of each link, lbf in, towards 0.4 rad
    spring: np.ndarray = np.zeros(2)  # of a joint, lbf in/rad
    detent: np.ndarray = np.zeros(2)  # sin(9 q), in no library
    cable: float = 0.0  # lbf/in from the tip to (20, 10) in, slack below 3 in
    tip_drag: float = 0.0  # lbf s/in
    payload: float = 0.0  # lbf s^2/in at the handle
    inertia: np.ndarray = np.zeros(3)  # relative: M11, M22, gamma
    lengths: np.ndarray = np.zeros(2)  # relative


@numba.njit(cache=True)
def _effective(T, i, u, play):
    """Excitation that the torque map sees; `play` (4, 4) holds the plays' outputs."""
    for k in range(4):
        r = T.remanence[i] if k == 3 else 0.5 * (k + 1.0)
        play[i, k] = min(max(play[i, k], u - r), u + r)
    seen = u
    if T.hysteresis[i] != 0.0:
        s = T.hysteresis[i]
        seen = (1.0 - s) * u + s * (0.5 * play[i, 0] + 0.3 * play[i, 1] + 0.2 * play[i, 2])
    if T.remanence[i] != 0.0:
        seen = play[i, 3]
    return max(seen, 0.0)


@numba.njit(cache=True)
def _factor(T, i, sign, angle, u, t, heat, way, push):
    f = T.scale[i] * (1.0 + T.asymmetry[i] * sign * (1.1 - 0.03 * u))
    f *= 1.0 + T.position[i] * (np.cos(angle - 0.7) + 0.25 * np.cos(3.0 * angle))
    f /= 1.0 + T.fade[i] * heat / 100.0
    f *= 1.0 + T.wear[i] * (1.0 - np.exp(-((way / 0.6) ** 0.9)))
    return f * (1.0 + T.drift[i] * t) * (1.0 + T.grip[i] * push / 18.0)


@numba.njit(cache=True)
def _speed_factor(T, i, w):
    f = 1.0 + T.stribeck[i] / (1.0 + (w / 0.12) ** 2)
    return f * (1.0 + T.log_speed[i] * np.arcsinh(w / 0.04)) * (
        1.0 + T.degressive[i] * (1.0 - np.exp(-w / 0.35)))  # fmt: skip


@numba.njit(cache=True)
def _hand(t, tip, rate, path, phase, F):
    """A hand that follows its own path, soft, and pushes 18 lbf at the most."""
    for k in range(2):
        want, speed = 0.0, 0.0
        for j in range(path.shape[1]):
            w = 2 * np.pi * path[k, j, 1]
            want += path[k, j, 0] * (np.sin(w * t + phase[k, j]) - np.sin(phase[k, j]))
            speed += path[k, j, 0] * w * np.cos(w * t + phase[k, j])
        f = 3.2 * (want - tip[k]) + 0.25 * (speed * (1.0 - np.exp(-4.0 * t)) - rate[k])
        F[k] = 18.0 * np.tanh(f / 18.0)


@numba.njit(cache=True)
def _actuate(T, told, total, u, first, timer, on, play, seen):
    """All clutches over one step; `seen` is what the torque maps see in its middle."""
    for i in range(4):
        cmd = told[i]
        if cmd > 0.0:
            cmd = cmd * (1.0 + T.command[i] * (1.2 - 0.04 * cmd)) + T.offset[i]
            cmd = max(0.0, cmd * (1.0 - T.sag[i] * (total - u[i])))
        for k in range(4):
            cmd += T.leak[i, k] * u[k] * (1.1 - 0.03 * u[k])
        if on[i] and told[i] <= 0.05 and u[i] <= 0.05:
            on[i], u[i], first[i] = False, 0.0, 0.0
        if not on[i]:
            timer[i] = timer[i] + H if told[i] > 0.05 else 0.0
            wait = 0.02 + T.pull_in[i] * (1.0 + 1.0 / max(told[i], 1.0))
            on[i] = told[i] > 0.05 and timer[i] > wait + 1e-9
            for k in range(4):
                play[i, k] = 0.0
            seen[i] = 0.0
        if on[i]:
            timer[i] = 0.0
            drive = cmd
            if T.second_lag[i] > 0.0:
                first[i] += (cmd - first[i]) * (1.0 - np.exp(-H / T.second_lag[i]))
                drive = first[i]
            tau = 0.07 * (1.0 + T.lag[i]) * (1.0 + (T.release[i] if drive < u[i] else 0.0))
            step = (drive - u[i]) * (1.0 - np.exp(-H / tau))
            if T.slew[i] > 0.0:
                most = H / T.slew[i]
                step = most * np.tanh(step / most)
            u[i] += 0.5 * step
            seen[i] = _effective(T, i, u[i], play)
            for k in range(4):
                seen[i] = max(0.0, seen[i] + T.field[i, k] * u[k] * (1.05 - 0.015 * u[k]))
            u[i] += 0.5 * step


@numba.njit(cache=True)
def _levels(T, q, w, t, push, on, stuck, seen, heat, way, rest, slip, brk):
    """Slip and breakaway torques (4, 2), forward and backward."""
    for i in range(4):
        angle = q[i] if i < 2 else (q[0] - q[1] if i == 2 else q[0] + q[1])
        e, speed = seen[i], 0.0 if stuck[i] else abs(w[i])
        for d in range(2 if on[i] else 0):
            f = _factor(T, i, 1.0 - 2.0 * d, angle, e, t, heat[i], way[i], push)
            curve = (6.439 * e + 0.137) * e + 0.371
            slip[i, d] = f * _speed_factor(T, i, speed) * (0.154 * speed + 0.9409) * curve
            brk[i, d] = f * ((6.648 * e + 6.176) * e + 5.253)
            brk[i, d] *= 1.0 + T.dwell[i] * np.log10(1.0 + rest[i] / 0.05)
            brk[i, d] = max(brk[i, d], slip[i, d])


@numba.njit(cache=True)
def _push(T, q, v, la, ld, tip0, t, path, phase, tip, rate, F, base):
    """Tip force `F` of the hand, and all torques but the clutches' that follow no speed."""
    s1, c1, s2, c2 = np.sin(q[0]), np.cos(q[0]), np.sin(q[1]), np.cos(q[1])
    x, y = la * c1 - ld * s2, la * s1 + ld * c2
    tip[0], tip[1] = x - tip0[0], y - tip0[1]
    rate[0] = -la * s1 * v[0] - ld * c2 * v[1]
    rate[1] = la * c1 * v[0] - ld * s2 * v[1]
    _hand(t, tip, rate, path, phase, F)
    gx, gy = F[0] - T.tip_drag * rate[0], F[1] - T.tip_drag * rate[1]
    far = np.hypot(20.0 - x, 10.0 - y)
    if far > 3.0:
        gx += T.cable * (far - 3.0) * (20.0 - x) / far
        gy += T.cable * (far - 3.0) * (10.0 - y) / far
    # The weights of the links: link 1 lies along q1, link 2 across q2.
    base[0] = -la * s1 * gx + la * c1 * gy - T.tilt[0] * np.sin(q[0] - 0.4)
    base[1] = -ld * c2 * gx - ld * s2 * gy - T.tilt[1] * np.cos(q[1] - 0.4)
    for j in range(2):
        base[j] += T.bias[j] - T.spring[j] * (q[j] - (1.0 + 0.8 * j))
        base[j] -= T.detent[j] * np.sin(9.0 * q[j])


@numba.njit(cache=True)
def _remember(on, stuck, work, p, rest, heat, way):
    """What the clutches keep of a step: rest, dissipated energy, way; `work[4]`: mean slips."""
    for i in range(4):
        stuck[i] = on[i] and abs(work[1, i]) <= 1e-9
        rest[i] = rest[i] + H if stuck[i] else 0.0
        moved = abs(work[4, i]) * H
        heat[i] += abs(p[i]) / H * moved - heat[i] * H / 3.0
        way[i] += moved if on[i] else 0.0


@numba.njit(cache=True)
def integrate(T, q0, table, path, phase):
    """Rows (t, theta_1, theta_2, force x, y) of one run; `table` holds the commands of each tick.

    The force is that on the tip, the angles are exact: sensors come later.
    """
    rows = np.empty((round(DURATION / H) // EVERY, 5))
    la, ld = 36.4 * (1.0 + T.lengths[0]), 24.1 * (1.0 + T.lengths[1])
    m = np.array([300.0 * (1.0 + T.inertia[0]) + T.payload * la * la, 0.0,
                  90.0 * (1.0 + T.inertia[1]) + T.payload * ld * ld])  # fmt: skip
    across = 12.0 * (1.0 + T.inertia[2]) + T.payload * la * ld  # times sin(q1 - q2)
    q, v, qm = q0.copy(), np.zeros(2), np.zeros(2)
    u, first, timer, seen, low, high, rest, heat, way, p = np.zeros((10, 4))
    on, stuck = np.zeros(4, np.bool_), np.zeros(4, np.bool_)
    play, slip, brk, work = np.zeros((4, 4)), np.zeros((4, 2)), np.zeros((4, 2)), np.zeros((6, 4))
    tip, rate, F, base = np.zeros((4, 2))
    tip0 = np.array([la * np.cos(q[0]) - ld * np.sin(q[1]), la * np.sin(q[0]) + ld * np.cos(q[1])])
    for k in range(round(DURATION / H)):
        t = k * H
        if k % EVERY == 0:
            _push(T, q, v, la, ld, tip0, t, path, phase, tip, rate, F, base)
            rows[k // EVERY, 0] = t
            rows[k // EVERY, 1:3] = q
            rows[k // EVERY, 3:5] = F
        _actuate(T, table[int(t * TICK + 1e-7)], u.sum(), u, first, timer, on, play, seen)
        qm[0], qm[1] = q[0] + 0.5 * H * v[0], q[1] + 0.5 * H * v[1]
        _push(T, qm, v, la, ld, tip0, t + 0.5 * H, path, phase, tip, rate, F, base)
        slips(v, work[0])
        push = np.hypot(F[0], F[1])
        _levels(T, qm, work[0], t, push, on, stuck, seen, heat, way, rest, slip, brk)
        m[1] = across * np.sin(qm[0] - qm[1])
        coriolis = across * np.cos(qm[0] - qm[1])
        new = advance(T, v, base, m, coriolis, on, stuck, slip, brk, p, low, high, work)
        for j in range(2):
            v[j] = 0.5 * (v[j] + new[j])
            q[j] += H * v[j]
        slips(v, work[4])
        _remember(on, stuck, work, p, rest, heat, way)
        v[0], v[1] = new[0], new[1]
    return rows
