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

H = 1e-4
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
def _impulses(A, b, low, high, p):
    """Box-constrained: minimise p A p / 2 + b p by sweeps from the last solution."""
    for i in range(4):
        p[i] = min(max(p[i], low[i]), high[i])
    for _ in range(400):
        moved = 0.0
        for i in range(4):
            if low[i] == high[i]:
                p[i] = low[i]
                continue
            g = b[i]
            for j in range(4):
                g += A[i, j] * p[j]
            new = min(max(p[i] - g / A[i, i], low[i]), high[i])
            moved = max(moved, abs(new - p[i]))
            p[i] = new
        if moved < 1e-13:
            break


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
def integrate(T, q0, table, path, phase):
    """Rows (t, theta_1, theta_2, force x, y) of one run; `table` holds the commands of each tick.

    The force is that on the tip, the angles are exact: sensors come later.
    """
    steps = round(DURATION / H)
    rows = np.empty((steps // EVERY, 5))
    C = np.array([[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]])
    la, ld = 36.4 * (1.0 + T.lengths[0]), 24.1 * (1.0 + T.lengths[1])
    m11 = 300.0 * (1.0 + T.inertia[0]) + T.payload * la * la
    m22 = 90.0 * (1.0 + T.inertia[1]) + T.payload * ld * ld
    m12 = 12.0 * (1.0 + T.inertia[2]) + T.payload * la * ld  # times sin(q1 - q2)
    q, v = q0.copy(), np.zeros(2)
    u, first, timer = np.zeros(4), np.zeros(4), np.zeros(4)
    on, stuck = np.zeros(4, np.bool_), np.zeros(4, np.bool_)
    rest, heat, way, p = np.zeros(4), np.zeros(4), np.zeros(4), np.zeros(4)
    play, seen = np.zeros((4, 4)), np.zeros(4)
    low, high, b, w = np.zeros(4), np.zeros(4), np.zeros(4), np.zeros(4)
    slip, brk = np.zeros((4, 2)), np.zeros((4, 2))
    tip, rate, F, tip0 = np.zeros(2), np.zeros(2), np.zeros(2), np.zeros(2)
    tip0[0] = la * np.cos(q[0]) - ld * np.sin(q[1])
    tip0[1] = la * np.sin(q[0]) + ld * np.cos(q[1])
    for k in range(steps):
        t = k * H
        told = table[int(t * TICK + 1e-7)]
        if k % EVERY == 0:
            J = np.array([[-la * np.sin(q[0]), -ld * np.cos(q[1])],
                          [la * np.cos(q[0]), -ld * np.sin(q[1])]])  # fmt: skip
            tip[0] = la * np.cos(q[0]) - ld * np.sin(q[1]) - tip0[0]
            tip[1] = la * np.sin(q[0]) + ld * np.cos(q[1]) - tip0[1]
            _hand(t, tip, J @ v, path, phase, F)
            rows[k // EVERY] = np.array([t, q[0], q[1], F[0], F[1]])
        total = u.sum()
        for i in range(4):  # actuators, to the middle and the end of the step
            cmd = told[i]
            if cmd > 0.0:
                cmd = cmd * (1.0 + T.command[i] * (1.2 - 0.04 * cmd)) + T.offset[i]
                cmd = max(0.0, cmd * (1.0 - T.sag[i] * (total - u[i])))
            if on[i] and told[i] <= 0.05 and u[i] <= 0.05:
                on[i], u[i], first[i] = False, 0.0, 0.0
            if not on[i]:
                timer[i] = timer[i] + H if told[i] > 0.05 else 0.0
                wait = 0.02 + T.pull_in[i] * (1.0 + 1.0 / max(told[i], 1.0))
                on[i] = told[i] > 0.05 and timer[i] > wait + 1e-9
                play[i] = 0.0
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
                u[i] += 0.5 * step
        qm = q + 0.5 * H * v
        s1, c1, s2, c2 = np.sin(qm[0]), np.cos(qm[0]), np.sin(qm[1]), np.cos(qm[1])
        J = np.array([[-la * s1, -ld * c2], [la * c1, -ld * s2]])
        tip[0], tip[1] = la * c1 - ld * s2 - tip0[0], la * s1 + ld * c2 - tip0[1]
        rate = J @ v
        _hand(t + 0.5 * H, tip, rate, path, phase, F)
        push = np.hypot(F[0], F[1])
        gx, gy = F[0] - T.tip_drag * rate[0], F[1] - T.tip_drag * rate[1]
        dx, dy = 20.0 - la * c1 + ld * s2, 10.0 - la * s1 - ld * c2
        far = np.hypot(dx, dy)
        if far > 3.0:
            gx += T.cable * (far - 3.0) * dx / far
            gy += T.cable * (far - 3.0) * dy / far
        sine, cosine = np.sin(qm[0] - qm[1]), np.cos(qm[0] - qm[1])
        M = np.array([[m11, m12 * sine], [m12 * sine, m22]])
        inverse = np.linalg.inv(M)
        # The force of the links' weights: link 1 lies along q1, link 2 across q2.
        base = J.T @ np.array([gx, gy])
        base[0] -= T.tilt[0] * np.sin(qm[0] - 0.4)
        base[1] -= T.tilt[1] * np.cos(qm[1] - 0.4)
        for j in range(2):
            base[j] += T.bias[j] - T.spring[j] * (qm[j] - (1.0 + 0.8 * j))
            base[j] -= T.detent[j] * np.sin(9.0 * qm[j])
        for i in range(4):
            wi = C[i, 0] * v[0] + C[i, 1] * v[1]
            angle = C[i, 0] * qm[0] + C[i, 1] * qm[1]
            e, speed = seen[i], 0.0 if stuck[i] else abs(wi)
            for d in range(2):
                f = _factor(T, i, 1.0 - 2.0 * d, angle, e, t, heat[i], way[i], push)
                curve = (6.439 * e + 0.137) * e + 0.371
                slip[i, d] = f * _speed_factor(T, i, speed) * (0.154 * speed + 0.9409) * curve
                brk[i, d] = f * ((6.648 * e + 6.176) * e + 5.253)
                brk[i, d] *= 1.0 + T.dwell[i] * np.log10(1.0 + rest[i] / 0.05)
                brk[i, d] = max(brk[i, d], slip[i, d])
        A = C @ inverse @ C.T
        new = v.copy()
        holds = stuck.copy()
        for _ in range(6):
            mid = 0.5 * (v + new)
            force = base.copy()
            force[0] -= -m12 * cosine * mid[1] ** 2
            force[1] -= m12 * cosine * mid[0] ** 2
            for j in range(2):
                a = mid[j]
                force[j] -= T.viscous[j] * a * (1.0 + 0.15 * a * a)
                force[j] -= T.quadratic[j] * a * abs(a) + T.dry[j] * np.tanh(a / 0.01)
            free = v + H * (inverse @ force)
            for i in range(4):
                b[i] = C[i, 0] * free[0] + C[i, 1] * free[1]
                level = brk[i] if holds[i] else slip[i]
                low[i], high[i] = (-H * level[0], H * level[1]) if on[i] else (0.0, 0.0)
            _impulses(A, b, low, high, p)
            last = new
            new = free + inverse @ (C.T @ p)
            again = np.abs(new - last).max() > 1e-12
            for i in range(4):
                w[i] = C[i, 0] * new[0] + C[i, 1] * new[1]
                was = C[i, 0] * v[0] + C[i, 1] * v[1]
                if on[i] and holds[i] and abs(w[i]) > 1e-9:
                    holds[i], again = False, True
                elif on[i] and not holds[i] and not stuck[i] and was * w[i] < -1e-9 * abs(was):
                    holds[i], again = True, True
            if not again:
                break
        mid = 0.5 * (v + new)
        q = q + H * mid
        v = new
        for i in range(4):
            stuck[i] = on[i] and abs(w[i]) <= 1e-9
            rest[i] = rest[i] + H if stuck[i] else 0.0
            moved = abs(C[i, 0] * mid[0] + C[i, 1] * mid[1]) * H
            heat[i] += abs(p[i]) / H * moved - heat[i] * H / 3.0
            way[i] += moved if on[i] else 0.0
    return rows
