"""Order reduction: which speeds a set of stuck clutches leaves free, and what it takes to hold.

A stuck set S removes rank(C_S) coordinates.  ``partition`` chooses, by elimination with full
pivoting, as many independent rows (``rows``) and dependent coordinates (first entries of
``cols``); the other coordinates' speeds are the reduced state, and the dependent ones follow from
``qd_D = B qd_I``.  With an integer clutch map (PTER) B is exact, and so is the slip velocity zero.
"""

from .linear import solve, solve_many
from .records import STICK


def partition(C, n, m, mode, rows, cols, s):
    """Independent stuck rows and a split into dependent and independent coordinates.

    Returns the rank r; ``rows[:r]`` are clutches, ``cols[:r]`` dependent coordinates and
    ``cols[r:]`` independent ones.  Rows are independent when the pivot left after elimination
    exceeds 1e-9 of the largest entry (a statement about geometry, not about speeds).
    """
    count = 0
    scale = 0.0
    for i in range(m):
        if mode[i] == STICK:
            rows[count] = i
            for j in range(n):
                s[count * n + j] = C[i * n + j]
                if abs(C[i * n + j]) > scale:
                    scale = abs(C[i * n + j])
            count += 1
    for j in range(n):
        cols[j] = j
    r = 0
    while r < count and r < n:
        best, pr, pc = full_pivot(s, n, cols, r, count)
        if best <= 1e-9 * scale:
            break
        keep_row = rows[r]
        rows[r] = rows[pr]
        rows[pr] = keep_row
        eliminate(s, n, cols, r, count, pr, pc)
        r += 1
    return r


def choose_columns(C, n, rows, cols, r, s):
    """Dependent coordinates anew, for the rows that a mode has and the clutch map of this pose.

    What followed well from the other coordinates where a mode began need not do so where it has
    come: a body on a cable that is held goes past the place where its height says nothing of its
    way.  By the pose alone, so that it does not matter from where it was reached.
    """
    for a in range(r):
        for b in range(n):
            s[a * n + b] = C[rows[a] * n + b]
    for j in range(n):
        cols[j] = j
    for a in range(r):
        best, pr, pc = full_pivot(s, n, cols, a, r)
        if best == 0.0:
            return
        eliminate(s, n, cols, a, r, pr, pc)


def eliminate(s, n, cols, r, count, pr, pc):
    """Bring the pivot at row ``pr``, column ``pc`` to place ``r``; take it from the rows below."""
    if pr != r:
        for b in range(n):
            keep = s[r * n + b]
            s[r * n + b] = s[pr * n + b]
            s[pr * n + b] = keep
    if pc != r:
        keep_col = cols[r]
        cols[r] = cols[pc]
        cols[pc] = keep_col
    for a in range(r + 1, count):
        factor = s[a * n + cols[r]] / s[r * n + cols[r]]
        if factor != 0.0:
            for b in range(r, n):
                s[a * n + cols[b]] -= factor * s[r * n + cols[b]]


def full_pivot(s, n, cols, r, count):
    """The largest entry of what elimination has left from ``r`` on: (size, row, column)."""
    best = 0.0
    pr = r
    pc = r
    for a in range(r, count):
        for b in range(r, n):
            # Strictly larger by more than rounding, so that ties go to the first.
            if abs(s[a * n + cols[b]]) > best * (1.0 + 1e-12):
                best = abs(s[a * n + cols[b]])
                pr = a
                pc = b
    return best, pr, pc


def dependence(C, n, rows, cols, r, B, s):
    """``B`` (r, n-r) with ``qd_D = B qd_I`` for the partition; returns a status."""
    k = n - r
    if r == 0 or k == 0:
        return 0
    for a in range(r):
        for b in range(r):
            s[a * r + b] = C[rows[a] * n + cols[b]]
        for b in range(k):
            B[a * k + b] = -C[rows[a] * n + cols[r + b]]
    return solve_many(s, B, r, k)


def project_speeds(y, n, cols, r, B):
    """Overwrite the dependent speeds in ``y = [q, qd, ...]`` by what the stuck set leaves them."""
    k = n - r
    for a in range(r):
        total = 0.0
        for b in range(k):
            total += B[a * k + b] * y[n + cols[r + b]]
        y[n + cols[a]] = total


def take_slip(y, n, C, rows, r, s):
    """Take off the speeds in ``y`` what slips in the stuck rows: the smallest change that does it.

    Which coordinates are dependent changes with the pose; this does not, so a flow that takes it
    is smooth where they change.
    """
    at = r * r
    for a in range(r):
        total = 0.0
        for j in range(n):
            total += C[rows[a] * n + j] * y[n + j]
        s[at + a] = total
        for b in range(r):
            total = 0.0
            for j in range(n):
                total += C[rows[a] * n + j] * C[rows[b] * n + j]
            s[a * r + b] = total
    slip = s[at : at + r]
    if solve(s, slip, r) == 0:
        for a in range(r):
            for j in range(n):
                y[n + j] -= C[rows[a] * n + j] * slip[a]


def accelerations(M, f, C, c, n, rows, cols, r, B, constant, qdd, s):
    """``qdd`` of ``M qdd = f + C_S^T tau`` with the stuck rows' slip acceleration zero.

    ``c`` is Cdot qd; ``constant`` says that it vanishes.  Returns a status.
    """
    k = n - r
    if r == 0:
        for i in range(n * n):
            s[i] = M[i]
        for i in range(n):
            qdd[i] = f[i]
        return solve(s, qdd, n)
    for a in range(n):
        qdd[a] = 0.0
    if not constant:
        status = asked_by_map(C, c, n, rows, cols, r, qdd, s)
        if status != 0:
            return status
    if k == 0:
        return 0
    reduced_system(M, f, n, cols, r, B, constant, qdd, s)
    at_rhs = k * k
    v = s[at_rhs : at_rhs + k]
    status = solve(s, v, k)
    if status != 0:
        return status
    for b in range(k):
        qdd[cols[r + b]] = v[b]
    for a in range(r):
        total = qdd[cols[a]]
        for b in range(k):
            total += B[a * k + b] * v[b]
        qdd[cols[a]] = total
    return 0


def asked_by_map(C, c, n, rows, cols, r, qdd, s):
    """gamma: the acceleration that a configuration-dependent map asks of the dependent coordinates.

    Written to ``qdd`` in their places; returns a status.
    """
    off = r * r
    for a in range(r):
        for b in range(r):
            s[a * r + b] = C[rows[a] * n + cols[b]]
        s[off + a] = -c[rows[a]]
    right = s[off : off + r]
    status = solve(s, right, r)
    if status != 0:
        return status
    for a in range(r):
        qdd[cols[a]] = right[a]
    return 0


def reduced_system(M, f, n, cols, r, B, constant, gamma, s):
    """``N^T M N`` (k*k) and ``N^T (f - M gamma)`` (k,) into ``s``; N = [I; B] in partition order.

    ``constant`` says that ``gamma`` (n,) vanishes.
    """
    k = n - r
    at_rhs = k * k
    for a in range(k):
        ia = cols[r + a]
        for b in range(k):
            ib = cols[r + b]
            total = M[ia * n + ib]
            for d in range(r):
                jd = cols[d]
                total += M[ia * n + jd] * B[d * k + b] + B[d * k + a] * M[jd * n + ib]
                for e in range(r):
                    total += B[d * k + a] * M[jd * n + cols[e]] * B[e * k + b]
            s[a * k + b] = total
        total = f[ia]
        for d in range(r):
            total += B[d * k + a] * f[cols[d]]
        if not constant:
            for e in range(r):
                je = cols[e]
                total -= M[ia * n + je] * gamma[je]
                for d in range(r):
                    total -= B[d * k + a] * M[cols[d] * n + je] * gamma[je]
        s[at_rhs + a] = total


def held_force(M, f, C, n, rows, cols, r, qdd, lam, s):
    """Torques ``lam`` (r,) on the independent stuck rows that give ``qdd``; returns a status."""
    for a in range(r):
        ja = cols[a]
        total = -f[ja]
        for b in range(n):
            total += M[ja * n + b] * qdd[b]
        lam[a] = total
        for b in range(r):
            s[a * r + b] = C[rows[b] * n + ja]
    return solve(s, lam, r)
