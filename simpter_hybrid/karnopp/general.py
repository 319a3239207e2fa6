"""Karnopp's rule for any number of coordinates and clutches.

Every applied clutch inside the band sticks.  Its torque is what stops its slip acceleration; where
the stuck rows depend on each other, the torques of least norm in units of their breakaway torques
(a convention, which torque feedback can see: the exact engine states the same).  A torque above its
breakaway level is set to that level, worst first, and the others are computed again beside it; one
that would then drive its slip is taken back.
"""


def solve(a, b, k):
    """Solve ``a x = b`` (k unknowns) by elimination with pivoting, in place.  0, or 1: singular."""
    for i in range(k):
        top = i
        for r in range(i + 1, k):
            if abs(a[r * k + i]) > abs(a[top * k + i]):
                top = r
        if a[top * k + i] == 0.0:
            return 1
        if top != i:
            for j in range(k):
                a[i * k + j], a[top * k + j] = a[top * k + j], a[i * k + j]
            b[i], b[top] = b[top], b[i]
        for r in range(i + 1, k):
            factor = a[r * k + i] / a[i * k + i]
            for j in range(i, k):
                a[r * k + j] -= factor * a[i * k + j]
            b[r] -= factor * b[i]
    for i in range(k - 1, -1, -1):
        for j in range(i + 1, k):
            b[i] -= a[i * k + j] * b[j]
        b[i] /= a[i * k + i]
    return 0


def accelerate(n, M, load, x, a):
    """``x = M^-1 load`` (n,); ``a`` (n*n) is scratch.  Returns a status."""
    for j in range(n * n):
        a[j] = M[j]
    for j in range(n):
        x[j] = load[j]
    return solve(a, x, n)


def spread(n, m, C, flags, torque, out):
    """Add ``C^T torque`` of the flagged clutches to ``out`` (n,)."""
    for i in range(m):
        if flags[i] == 1:
            for j in range(n):
                out[j] += C[i * n + j] * torque[i]


def least_norm(n, m, M, w):
    """Torques of the clutches flagged in ``w.flag`` that cancel slip accelerations ``w.r`` (m,).

    Conjugate gradients on ``D C M^-1 C^T D x = -D r``, D = diag(``w.weight``), from zero: on a
    singular consistent system they give the solution of least norm, in as many steps as the system
    has rank.  ``D x`` goes to ``w.d`` (m,); ``w.r``, ``w.e``, ``w.along``, ``w.x``, ``w.rhs`` are
    scratch.
    """
    size = 0.0
    for i in range(m):
        w.d[i] = 0.0
        w.r[i] = -w.weight[i] * w.r[i] if w.flag[i] == 1 else 0.0
        w.e[i] = w.r[i]
        size += w.r[i] * w.r[i]
    start = size
    for _ in range(2 * m + 2):
        if size <= 1e-28 * start or size == 0.0:
            break
        for j in range(n):
            w.rhs[j] = 0.0
        for i in range(m):
            w.along[i] = w.weight[i] * w.e[i]
        spread(n, m, w.C, w.flag, w.along, w.rhs)
        if accelerate(n, M, w.rhs, w.x, w.a) != 0:
            return 1
        bend = 0.0
        for i in range(m):
            if w.flag[i] == 1:
                for j in range(n):
                    bend += w.along[i] * w.C[i * n + j] * w.x[j]
        if bend <= 0.0:
            break
        step = size / bend
        new = 0.0
        for i in range(m):
            if w.flag[i] == 1:
                w.d[i] += step * w.along[i]
                for j in range(n):
                    w.r[i] -= step * w.weight[i] * w.C[i * n + j] * w.x[j]
                new += w.r[i] * w.r[i]
        for i in range(m):
            w.e[i] = w.r[i] + new / size * w.e[i]
        size = new
    return 0


def weigh(m, w):
    """Breakaway torques of the stuck clutches into ``w.weight``, none below 1e-3 of their sum."""
    total = 0.0
    for i in range(m):
        w.weight[i] = 0.5 * (w.fr[m + i] + w.fr[2 * m + i])
        if w.stuck[i] == 1:
            total += w.weight[i]
    for i in range(m):
        w.weight[i] = max(w.weight[i], 1e-3 * total) if total > 0.0 else 1.0


def rest(n, m, C, flags, s, cols, speed):
    """Take what rounding left of the flagged clutches' slip out of ``speed`` (n,).

    Controllers read the sign of a slip, and that of 1e-17 is noise.  Gauss-Jordan elimination of
    the flagged rows gives some coordinates' speeds by the others': with an integer map (PTER) the
    slip is then exactly zero.  ``s`` (m * n) and ``cols`` (m,) are scratch.
    """
    count = 0
    for i in range(m):
        if flags[i] == 1:
            for j in range(n):
                s[count * n + j] = C[i * n + j]
            count += 1
    for a in range(count):
        col = 0
        for j in range(n):
            if abs(s[a * n + j]) > abs(s[a * n + col]):
                col = j
        pivot = s[a * n + col]
        cols[a] = col if abs(pivot) > 1e-9 else -1
        if cols[a] < 0:
            continue
        for j in range(n):
            s[a * n + j] /= pivot
        for b in range(count):
            factor = s[b * n + col]
            if b != a:
                for j in range(n):
                    s[b * n + j] -= factor * s[a * n + j]
    for a in range(count):
        if cols[a] >= 0:
            col = int(cols[a])
            total = 0.0
            for j in range(n):
                if j != col:
                    total -= s[a * n + j] * speed[j]
            speed[col] = total


def slip_accelerations(n, m, w):
    """``w.r`` (m,): slip accelerations under ``w.f`` and the torques ``w.now`` but for those
    flagged in ``w.flag``; ``w.e`` (m,): the size of the terms they are made of.  A status.
    """
    for j in range(n):
        w.speed[j] = w.f[j]
    for i in range(m):
        if w.flag[i] == 0:
            for j in range(n):
                w.speed[j] += w.C[i * n + j] * w.now[i]
    status = accelerate(n, w.M, w.speed, w.x, w.a)
    for i in range(m):
        w.r[i] = w.c[i]
        w.e[i] = abs(w.c[i])
        for j in range(n):
            w.r[i] += w.C[i * n + j] * w.x[j]
            w.e[i] += abs(w.C[i * n + j]) * (abs(w.x[j]) + abs(w.f[j]) / w.M[j * n + j])
    return status


def torques(n, m, w):
    """Torques of the stuck clutches (``w.stuck``) into ``w.now``; flags ``w.over`` where they slip.

    ``w.now`` already holds the torques of the other clutches.  Returns a status.
    """
    weigh(m, w)
    for _ in range(6 * m + 6):
        for i in range(m):
            w.flag[i] = 1 if w.stuck[i] == 1 and w.over[i] == 0 else 0
        if slip_accelerations(n, m, w) != 0 or least_norm(n, m, w.M, w) != 0:
            return 1
        worst = 1.0 + 1e-12
        which = -1
        for i in range(m):
            if w.flag[i] == 1:
                w.now[i] = w.d[i]
                limit = w.fr[2 * m + i] if w.d[i] >= 0.0 else w.fr[m + i]
                if abs(w.d[i]) > worst * limit:
                    worst = abs(w.d[i]) / limit if limit > 0.0 else 1e300
                    which = i
        if which >= 0:
            limit = w.fr[2 * m + which] if w.now[which] >= 0.0 else w.fr[m + which]
            w.now[which] = limit if w.now[which] > 0.0 else -limit
            w.over[which] = 1
        elif not recall(n, m, w):
            return 0
    return 0


def recall(n, m, w):
    """Take back the clutch that drives most among those set to breakaway; whether there was one.

    What is left slips against its torque; one that is at breakaway without slipping holds.
    """
    for i in range(m):
        w.flag[i] = 0
    if slip_accelerations(n, m, w) != 0:
        return False
    most = 1e-11
    which = -1
    for i in range(m):
        if w.over[i] == 1:
            way = w.r[i] if w.now[i] > 0.0 else -w.r[i]
            if way > most * w.e[i]:
                most = way / w.e[i]
                which = i
    if which >= 0:
        w.over[which] = 0
        return True
    for i in range(m):
        if w.over[i] == 1 and abs(w.r[i]) <= 1e-11 * w.e[i]:
            w.over[i] = 0
    return False
