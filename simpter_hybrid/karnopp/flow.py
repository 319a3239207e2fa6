"""The right-hand side: modes from the band, torques from the modes, limited speeds, accelerations.

Slip velocities, and with them the modes, come from the speeds as integrated ("Pre Vel" in the
thesis's Figures 3 and 7); the position integrator receives the limited ones.
"""

from .appendix import pair, single
from .general import accelerate, least_norm, rest, spread, torques
from .lumped import hold_or_slip, limit_of


def classify(md, o, y, w):
    """Flag the stuck clutches and set ``w.mode`` for the model's terms; returns how many stick.

    A clutch that is off gives no torque, whatever its speed.  By Table 1 two stuck clutches of PTER
    mean that everything is at rest (Case 7: "more than one clutch is stuck"): every other applied
    clutch then counts as stuck too, though its slip may reach twice the band.  One whose friction
    is a smooth function of states (bristles) never sticks: its torque has a sign of its own, and
    its mode stays 1.
    """
    n = md.n
    m = md.m
    md.map(y, md.p, w.C)
    count = 0
    for i in range(m):
        w.slip[i] = 0.0
        for j in range(n):
            w.slip[i] += w.C[i * n + j] * y[n + j]
        w.stuck[i] = 0
        w.over[i] = 0
        if w.gate[i] != 2:
            w.mode[i] = 2
        elif md.smooth[i] == 1:
            w.mode[i] = 1
        elif abs(w.slip[i]) <= o.band:
            w.mode[i] = 0
            w.stuck[i] = 1
            count += 1
        else:
            w.mode[i] = 1 if w.slip[i] > 0.0 else -1
    if o.table == 1 and count >= 2:
        for i in range(m):
            if (w.mode[i] == 1 or w.mode[i] == -1) and md.smooth[i] == 0:
                w.mode[i] = 0
                w.stuck[i] = 1
                count += 1
    return count


def clip(m, i, w):
    """Cut the torque of clutch ``i`` at its breakaway level; flags it when it is above."""
    limit = limit_of(w.fr, m, i, w.now[i])
    if abs(w.now[i]) > limit:
        w.now[i] = limit if w.now[i] > 0.0 else -limit
        w.over[i] = 1


def tabulated(m, o, count, w):
    """Torques of PTER's stuck clutches by Table 1 into ``w.now``; the others are already there."""
    if count > 2:
        hold_or_slip(m, o, w)
        return
    i = -1
    j = -1
    for c in range(m):
        if w.stuck[c] == 1:
            if i < 0:
                i = c
            else:
                j = c
    if count == 1:
        w.now[i] = single(i, w.M, w.f, w.now)
        clip(m, i, w)
        return
    pair(i, j, w.f, w.now)
    ask_i = abs(w.now[i])
    ask_j = abs(w.now[j])
    clip(m, i, w)
    clip(m, j, w)
    if o.resolve == 1 and w.over[i] + w.over[j] > 0:
        # The more overloaded one slips; the other is computed beside it.
        first_slips = ask_i * abs(w.now[j]) * w.over[i] >= ask_j * abs(w.now[i]) * w.over[j]
        if w.over[j] == 0 or (w.over[i] == 1 and first_slips):
            keep = j
        else:
            keep = i
        w.over[keep] = 0
        w.now[keep] = single(keep, w.M, w.f, w.now)
        clip(m, keep, w)


def limit_speeds(md, o, count, y, w):
    """The speeds that the position integrator receives, into ``w.speed`` (n,)."""
    n = md.n
    m = md.m
    for j in range(n):
        w.speed[j] = y[n + j]
        if o.limiter == 0 and abs(w.speed[j]) <= o.band:
            w.speed[j] = 0.0
    if count == 0 or o.limiter == 0 or o.limiter == 3:
        return
    held = 0
    which = -1
    for i in range(m):
        w.flag[i] = 1 if w.stuck[i] == 1 and w.over[i] == 0 else 0
        w.r[i] = w.slip[i]
        w.weight[i] = 1.0
        if w.flag[i] == 1:
            held += 1
            which = i
    if held == 0:
        return
    if o.table == 1:
        still(held, which, w.speed)
        return
    for j in range(n * n):
        w.s[j] = 1.0 if j % (n + 1) == 0 else 0.0
    least_norm(n, m, w.s, w)
    spread(n, m, w.C, w.flag, w.d, w.speed)
    rest(n, m, w.C, w.flag, w.s, w.e, w.speed)


def still(held, i, speed):
    """Take the slip of PTER's holding clutch ``i`` out of the link speeds, exactly."""
    if held > 1:
        speed[0] = 0.0
        speed[1] = 0.0
    elif i < 2:
        speed[i] = 0.0
    elif i == 2:
        speed[0] = 0.5 * (speed[0] + speed[1])
        speed[1] = speed[0]
    else:
        speed[0] = 0.5 * (speed[0] - speed[1])
        speed[1] = -speed[0]


def flow(md, o, t, y, w, dy):
    """Derivative of ``y`` at ``t``; torques go to ``w.now``, modes to ``w.mode``.  A status."""
    n = md.n
    m = md.m
    w.count[0] += 1
    count = classify(md, o, y, w)
    md.terms(t, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)
    for i in range(m):
        w.now[i] = -w.mode[i] * w.fr[i] if w.mode[i] == 1 or w.mode[i] == -1 else 0.0
    status = 0
    if count > 0:
        if o.table == 1:
            tabulated(m, o, count, w)
        else:
            status = torques(n, m, w)
    for i in range(m):
        w.tau[i] = w.now[i]
    limit_speeds(md, o, count, y, w)
    for j in range(n):
        w.qdd[j] = w.f[j]
    for i in range(m):
        for j in range(n):
            w.qdd[j] += w.C[i * n + j] * w.now[i]
    for j in range(n):
        w.rhs[j] = w.qdd[j]
    status += accelerate(n, w.M, w.rhs, w.qdd, w.a)
    md.rates(t, y, md.p, md.rec, w.held, w.mode, w.gate, w.dmode, w.tau, w.C, w.s, dy)
    ledger(md, w, dy)
    for i in range(m):
        if w.over[i] == 1:
            # Slipping as Karnopp's block sees it, though still inside the band.
            w.mode[i] = -1 if w.now[i] > 0.0 else 1
    return status


def ledger(md, w, dy):
    """Speeds, accelerations, and the work of every force along the displacement integrated."""
    n = md.n
    m = md.m
    load = 0.0
    effects = 0.0
    for j in range(n):
        dy[j] = w.speed[j]
        dy[n + j] = w.qdd[j]
        load += w.Q[j] * w.speed[j]
        effects += w.Q[n + j] * w.speed[j]
    at = md.ny - m - 2
    dy[at] = load
    dy[at + 1] = effects
    for i in range(m):
        power = 0.0
        for j in range(n):
            power -= w.now[i] * w.C[i * n + j] * w.speed[j]
        dy[at + 2 + i] = power
