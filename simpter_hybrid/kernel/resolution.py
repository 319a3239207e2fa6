"""Mode resolution: which of the clutches at zero slip hold, and which way the others slip.

Gauss's principle: among the engaged clutches at zero slip the accelerations are those of least
kinetic distance from the unconstrained ones, with friction torques bounded: a bounded least-squares
problem in the torques whose acceleration is unique even where its torques are not.  It is solved by
an active-set method, so that "holds" is a statement about sets, never a threshold on a speed.
"""

from .linear import solve, solve_many
from .records import BACKWARD, FORWARD


def bounded_torques(A, d, dsize, lo, hi, k, tau, state, x, s):
    """Minimize 1/2 tau^T A tau + d^T tau subject to lo <= tau <= hi.

    ``A`` (k, k) is C M^-1 C^T of the clutches at zero slip and ``d`` (k,) their slip acceleration
    without their torques, ``dsize`` (k,) the size of the terms that d is the sum of: a slip
    acceleration below 1e-11 of its terms is rounding.  ``state`` on return: 0 holds (slip
    acceleration zero), +1 slips forward, -1 slips backward.  Returns a status: 0, or 1 when the
    iteration limit is reached.
    """
    # state during the iteration: 1 free (in the basis), 0 fixed at its present torque
    for i in range(k):
        state[i] = 0
        tau[i] = 0.0 if lo[i] <= 0.0 <= hi[i] else lo[i]
    for _ in range(60 * (k + 1)):
        # Who wants to move? The worst violation enters.
        enter = -1
        worst = 0.0
        for i in range(k):
            if state[i] == 0:
                sigma = d[i]
                size = dsize[i]
                for j in range(k):
                    sigma += A[i * k + j] * tau[j]
                    size += abs(A[i * k + j] * tau[j])
                if (sigma > 0.0 and tau[i] > lo[i]) or (sigma < 0.0 and tau[i] < hi[i]):
                    violation = abs(sigma) / (size + 1e-300)
                    if violation > 1e-11 and violation > worst * (1.0 + 1e-9):
                        worst = violation
                        enter = i
        if enter < 0:
            classify(A, d, dsize, k, tau, state)
            return 0
        sigma = d[enter]
        for j in range(k):
            sigma += A[enter * k + j] * tau[j]
        travel(A, lo, hi, k, tau, state, enter, sigma, x, s)
    return 1


def travel(A, lo, hi, k, tau, state, enter, sigma, x, s):
    """Move ``enter`` downhill, the basis following, to its optimum or through blocking bounds."""
    done = False
    while not done:
        slope = basis_response(A, k, state, enter, x, s)
        down = -1.0 if sigma > 0.0 else 1.0
        dependent = slope <= 1e-9 * A[enter * k + enter]
        step = 1e300 if dependent else abs(sigma) / slope
        block = -2
        room = (hi[enter] - tau[enter]) if down > 0.0 else (tau[enter] - lo[enter])
        if room < step:
            step = room
            block = -1
        e = 0
        for j in range(k):
            if state[j] == 1:
                move = x[e] * down
                e += 1
                if move > 1e-14:
                    room = (hi[j] - tau[j]) / move
                elif move < -1e-14:
                    room = (lo[j] - tau[j]) / move
                else:
                    room = 1e300
                if room < step:
                    step = room if room > 0.0 else 0.0
                    block = j
        tau[enter] += down * step
        e = 0
        for j in range(k):
            if state[j] == 1:
                tau[j] += down * step * x[e]
                e += 1
        if not dependent:
            sigma += slope * down * step
        if block == -2:
            state[enter] = 1
            done = True
        elif block == -1:
            tau[enter] = hi[enter] if down > 0.0 else lo[enter]
            done = True
        else:
            tau[block] = hi[block] if tau[block] > 0.5 * (hi[block] + lo[block]) else lo[block]
            state[block] = 0


def basis_response(A, k, state, enter, x, s):
    """Torques ``x`` that keep the basis at zero slip while ``tau[enter]`` changes by one unit.

    Returns by how much the slip acceleration of ``enter`` changes then.
    """
    count = 0
    for i in range(k):
        if state[i] == 1:
            e = 0
            for j in range(k):
                if state[j] == 1:
                    s[count * k + e] = A[i * k + j]
                    e += 1
            x[count] = -A[i * k + enter]
            count += 1
    for i in range(count):
        for j in range(count):
            s[i * count + j] = s[i * k + j]
    solve(s, x, count)
    slope = A[enter * k + enter]
    e = 0
    for j in range(k):
        if state[j] == 1:
            slope += A[enter * k + j] * x[e]
            e += 1
    return slope


def classify(A, d, dsize, k, tau, state):
    """Turn basis membership into holds/slips: rows in the span of the basis hold as well."""
    for i in range(k):
        if state[i] == 1:
            continue
        sigma = d[i]
        size = dsize[i]
        for j in range(k):
            sigma += A[i * k + j] * tau[j]
            size += abs(A[i * k + j] * tau[j])
        if abs(sigma) <= 1e-11 * size:
            state[i] = 1
        else:
            state[i] = 2 if sigma > 0.0 else -2
    for i in range(k):
        if state[i] == 1:
            state[i] = 0
        elif state[i] != 0:
            state[i] = 1 if state[i] > 0 else -1


def resolve(n, m, M, f, C, c, fr, mode, zero, hold, pattern, margin, w):
    """New modes of the clutches at zero slip; ``mode`` is updated in place.

    ``zero`` flags the engaged clutches at zero slip, ``hold`` those of them that may hold up to
    their breakaway torque; the others of them are bounded by the slip torque at 0+.  ``pattern``
    (m,) is the slip pattern of the facet that has just broken (zeros: none) and ``margin`` its
    margin.  Returns a status: 0, or 1 (singular mass matrix), 2 (iteration limit).
    """
    status = 0
    if not facet_decides(m, fr, mode, pattern, margin, w.released):
        status = least_motion(n, m, M, f, C, c, fr, mode, zero, hold, w)
    for i in range(m):
        if zero[i] == 1:
            w.released[i] = mode[i]
    return status


def least_motion(n, m, M, f, C, c, fr, mode, zero, hold, w):
    """Modes by Gauss's principle; a clutch that slips in the solution loses its breakaway bound."""
    if relax(n, m, M, f, C, c, fr, mode, zero, w) != 0:
        return 1
    k = 0
    for i in range(m):
        if zero[i] == 1:
            w.index[k] = i
            k += 1
    while True:
        for a in range(k):
            i = w.index[a]
            w.lo[a] = -fr[m + i] if hold[i] == 1 else -fr[3 * m + i]
            w.hi[a] = fr[2 * m + i] if hold[i] == 1 else fr[4 * m + i]
        if bounded_torques(w.A, w.d, w.dsize, w.lo, w.hi, k, w.x, w.state, w.xx, w.s) != 0:
            return 2
        removed = False
        for a in range(k):
            i = w.index[a]
            if w.state[a] != 0 and hold[i] == 1:
                hold[i] = 0
                removed = True
        if not removed:
            for a in range(k):
                mode[w.index[a]] = w.state[a]
            return 0


def facet_decides(m, fr, mode, pattern, margin, released):
    """Whether the broken facet alone gives the slip directions; if so, set them.

    Without a gap between breakaway and slip torque the slip acceleration at a located breakaway is
    zero by continuity, and its sign is noise: the facet says which way its clutches go.  Clutches
    that another facet ``released`` at this instant keep their direction.
    """
    reach = 0.0
    most = 0.0
    drop = 0.0
    for i in range(m):
        reach += abs(pattern[i])
        if pattern[i] > 0.0:
            most += pattern[i] * fr[2 * m + i]
            drop += pattern[i] * (fr[2 * m + i] - fr[4 * m + i])
        elif pattern[i] < 0.0:
            most -= pattern[i] * fr[m + i]
            drop -= pattern[i] * (fr[m + i] - fr[3 * m + i])
    if reach == 0.0 or drop > 1e-9 * most or margin < -1e-9 * most:
        return False
    for i in range(m):
        if pattern[i] > 0.0:
            mode[i] = BACKWARD
        elif pattern[i] < 0.0:
            mode[i] = FORWARD
        elif released[i] != 0:
            mode[i] = released[i]
    return True


def relax(n, m, M, f, C, c, fr, mode, zero, w):
    """Fill ``w.A``, ``w.d``, ``w.dsize``: slip accelerations of the clutches at zero slip."""
    k = 0
    for i in range(m):
        if zero[i] == 1:
            k += 1
    width = k + 1
    at = n * n
    for j in range(n * n):
        w.s[j] = M[j]
    for j in range(n):
        total = f[j]
        for i in range(m):
            if zero[i] == 0 and (mode[i] == FORWARD or mode[i] == BACKWARD):
                total -= mode[i] * fr[i] * C[i * n + j]
        w.s[at + j * width] = total
        a = 1
        for i in range(m):
            if zero[i] == 1:
                w.s[at + j * width + a] = C[i * n + j]
                a += 1
    x = w.s[at : at + n * width]
    if solve_many(w.s, x, n, width) != 0:
        return 1
    a = 0
    for i in range(m):
        if zero[i] == 1:
            w.d[a] = c[i]
            w.dsize[a] = abs(c[i])
            for j in range(n):
                w.d[a] += C[i * n + j] * x[j * width]
                w.dsize[a] += abs(C[i * n + j] * x[j * width])
            for b in range(k):
                total = 0.0
                for j in range(n):
                    total += C[i * n + j] * x[j * width + 1 + b]
                w.A[a * k + b] = total
            a += 1
    return 0
