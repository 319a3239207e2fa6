"""Case 7: three or four of PTER's clutches applied at rest, as one lumped actuator.

Thesis 3.2.3.4, (24)-(29) and Table 2.  The special cases put all but two of the applied clutches at
their breakaway torque and solve the links' equilibrium for the other two.  If one of them asks for
no more than the two can give, the set holds and that case's torques are returned (their sum is
right, the single ones mean nothing).  Otherwise some clutches slip: all of them, if every torque
computed in every case exceeds its breakaway level, else the two (three of four, in 7.5) whose
torques of the previous step are closest to breakaway; the remaining one follows from Cases 2 and 3.

Where the thesis is silent: the first special case that fits is returned, in the order (24)-(29),
plus before minus; of equally close clutches the first stays; a slipping clutch acts the way its
previous torque did, or, if it would then drive, the other way.
"""

from .appendix import pair, single


def limit_of(fr, m, i, tau):
    """Breakaway torque of clutch ``i`` in the direction of ``tau`` [N m]."""
    return fr[2 * m + i] if tau >= 0.0 else fr[m + i]


def hold_or_slip(m, o, w):
    """Torques of Case 7 into ``w.now`` (4,), and which clutches slip into ``w.over`` (4,)."""
    below = 0
    for i in range(m - 2, -1, -1):
        for j in range(m - 1, i, -1):
            if w.stuck[i] == 1 and w.stuck[j] == 1:
                found = special_cases(m, i, j, o.both, w)
                if found == -1:
                    for c in range(m):
                        w.now[c] = w.x[c]
                        w.over[c] = 0
                    return
                below += found
    stays = -1
    if below > 0:
        stays = furthest_from_breakaway(m, o.relative, w)
    for c in range(m):
        w.over[c] = 1 if w.stuck[c] == 1 and c != stays else 0
        w.now[c] = 0.0
        if w.over[c] == 1:
            w.now[c] = w.fr[8 + c] if w.last[c] >= 0.0 else -w.fr[4 + c]
    for _ in range(m):
        compute(stays, w)
        if not turn(m, w):
            return


def special_cases(m, i, j, both, w):
    """Special cases that leave clutches ``i`` and ``j`` to be computed, the rest at breakaway.

    Returns -1 when one of them holds (torques in ``w.x``), else how many computed torques were
    below their breakaway level.
    """
    first = -1
    second = -1
    for c in range(m):
        if w.stuck[c] == 1 and c != i and c != j:
            if first < 0:
                first = c
            else:
                second = c
    below = 0
    for sign in range(4 if second >= 0 else 2):
        if sign > 0 and both == 0:
            break
        for c in range(m):
            w.x[c] = 0.0
        w.x[first] = w.fr[8 + first] if sign % 2 == 0 else -w.fr[4 + first]
        if second >= 0:
            w.x[second] = w.fr[8 + second] if sign < 2 else -w.fr[4 + second]
        balance(m, i, j, w.f, w.C, w.x)
        fits = 0
        if abs(w.x[i]) <= limit_of(w.fr, 4, i, w.x[i]):
            fits += 1
        if abs(w.x[j]) <= limit_of(w.fr, 4, j, w.x[j]):
            fits += 1
        if fits == 2:
            return -1
        below += fits
    return below


def balance(m, i, j, f, C, x):
    """Torques of clutches ``i`` and ``j`` that stop both links beside the others' in ``x``."""
    x[4] = f[0]
    x[5] = f[1]
    for c in range(m):
        if c != i and c != j:
            x[4] += C[2 * c] * x[c]
            x[5] += C[2 * c + 1] * x[c]
    side = x[4:6]
    pair(i, j, side, x)


def furthest_from_breakaway(m, relative, w):
    """The applied clutch whose torque of the previous step was furthest from breakaway."""
    stays = -1
    most = -1e300
    for i in range(m):
        if w.stuck[i] == 1:
            limit = limit_of(w.fr, 4, i, w.last[i])
            left = limit - abs(w.last[i])
            if relative == 1:
                left = left / limit if limit > 0.0 else 0.0
            # Closer than rounding is equally close.
            if left > most + 1e-9 * limit:
                most = left
                stays = i
    return stays


def compute(stays, w):
    """Torque of the clutch that stays, cut at its breakaway level."""
    if stays < 0:
        return
    w.now[stays] = 0.0
    needed = single(stays, w.M, w.f, w.now)
    limit = limit_of(w.fr, 4, stays, needed)
    w.over[stays] = 1 if abs(needed) > limit else 0
    if w.over[stays] == 1:
        needed = limit if needed > 0.0 else -limit
    w.now[stays] = needed


def turn(m, w):
    """Turn a slipping clutch around that would drive; whether there was one."""
    M = w.M
    a = w.f[0]
    b = w.f[1]
    for c in range(m):
        if w.stuck[c] == 1:
            a += w.C[2 * c] * w.now[c]
            b += w.C[2 * c + 1] * w.now[c]
    det = M[0] * M[3] - M[1] * M[2]
    first = (M[3] * a - M[1] * b) / det
    second = (M[0] * b - M[2] * a) / det
    worst = 0.0
    which = -1
    for c in range(m):
        if w.stuck[c] == 1 and w.over[c] == 1:
            drive = w.now[c] * (w.C[2 * c] * first + w.C[2 * c + 1] * second)
            if drive > worst + 1e-12 * abs(w.now[c]):
                worst = drive
                which = c
    if which < 0:
        return False
    w.now[which] = -w.fr[4 + which] if w.now[which] > 0.0 else w.fr[8 + which]
    return True
