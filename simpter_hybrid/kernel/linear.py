"""Dense linear algebra for a handful of unknowns (flat, row-major, in place)."""


def solve(a, b, k):
    """Solve ``a x = b`` for ``k`` unknowns by Gaussian elimination with row pivoting.

    ``a`` (k*k) is destroyed and ``b`` (k,) overwritten by the solution.
    Returns 0, or 1 when ``a`` is singular to working precision.
    """
    if k == 1:
        if a[0] == 0.0:
            return 1
        b[0] /= a[0]
        return 0
    if k == 2:
        return solve_two(a, b)
    for i in range(k):
        big = i
        for r in range(i + 1, k):
            if abs(a[r * k + i]) > abs(a[big * k + i]):
                big = r
        if a[big * k + i] == 0.0:
            return 1
        if big != i:
            for j in range(i, k):
                keep = a[i * k + j]
                a[i * k + j] = a[big * k + j]
                a[big * k + j] = keep
            keep = b[i]
            b[i] = b[big]
            b[big] = keep
        for r in range(i + 1, k):
            factor = a[r * k + i] / a[i * k + i]
            if factor != 0.0:
                for j in range(i + 1, k):
                    a[r * k + j] -= factor * a[i * k + j]
                b[r] -= factor * b[i]
    for i in range(k - 1, -1, -1):
        total = b[i]
        for j in range(i + 1, k):
            total -= a[i * k + j] * b[j]
        b[i] = total / a[i * k + i]
    return 0


def solve_two(a, b):
    """``solve`` for two unknowns, operation by operation."""
    i = 2 if abs(a[2]) > abs(a[0]) else 0
    pivot = a[i]
    right = a[i + 1]
    first = b[i // 2]
    if pivot == 0.0:
        return 1
    factor = a[2 - i] / pivot
    under = a[3 - i] - factor * right
    if under == 0.0:
        return 1
    second = (b[1 - i // 2] - factor * first) / under
    b[0] = (first - right * second) / pivot
    b[1] = second
    return 0


def solve_many(a, b, k, count):
    """Solve ``a X = b`` for ``count`` right-hand sides; ``b`` is (k, count), overwritten."""
    for i in range(k):
        big = i
        for r in range(i + 1, k):
            if abs(a[r * k + i]) > abs(a[big * k + i]):
                big = r
        if a[big * k + i] == 0.0:
            return 1
        if big != i:
            for j in range(i, k):
                keep = a[i * k + j]
                a[i * k + j] = a[big * k + j]
                a[big * k + j] = keep
            for j in range(count):
                keep = b[i * count + j]
                b[i * count + j] = b[big * count + j]
                b[big * count + j] = keep
        for r in range(i + 1, k):
            factor = a[r * k + i] / a[i * k + i]
            if factor != 0.0:
                for j in range(i + 1, k):
                    a[r * k + j] -= factor * a[i * k + j]
                for j in range(count):
                    b[r * count + j] -= factor * b[i * count + j]
    for i in range(k - 1, -1, -1):
        for j in range(count):
            total = b[i * count + j]
            for r in range(i + 1, k):
                total -= a[i * k + r] * b[r * count + j]
            b[i * count + j] = total / a[i * k + i]
    return 0


def null_vector(rows, count, r, pivots, out):
    """The vector orthogonal to ``count = r - 1`` vectors of length ``r``.

    ``rows`` (count*r) is destroyed, ``pivots`` (r,) is integer scratch.  The largest entry of
    ``out`` (r,) has magnitude 1; its direction is that of the cofactors (for r = 3 the cross
    product), which turns with the vectors and never jumps from one side to the other.
    Returns 0, or 1 when the vectors are dependent (a pivot below 1e-9 of the largest entry).
    """
    scale = 0.0
    for i in range(count * r):
        if abs(rows[i]) > scale:
            scale = abs(rows[i])
    free = r * (r - 1) // 2
    side = 1.0
    for i in range(count):
        best = 0.0
        pr = i
        pc = 0
        for a in range(i, count):
            for b in range(r):
                if abs(rows[a * r + b]) > best:
                    best = abs(rows[a * r + b])
                    pr = a
                    pc = b
        if best <= 1e-9 * scale:
            return 1
        for b in range(r):
            keep = rows[i * r + b]
            rows[i * r + b] = rows[pr * r + b]
            rows[pr * r + b] = keep
        pivot = rows[i * r + pc]
        # The sign of the vectors' determinant without column ``free``: rows that changed places,
        # pivots below zero, and pivots whose columns are not in their order.
        if (pr != i) != (pivot < 0.0):
            side = -side
        for a in range(i):
            if pivots[a] > pc:
                side = -side
        for b in range(r):
            rows[i * r + b] /= pivot
        for a in range(count):
            if a != i:
                factor = rows[a * r + pc]
                for b in range(r):
                    rows[a * r + b] -= factor * rows[i * r + b]
        pivots[i] = pc
        free -= pc
    if free % 2 == 1:
        side = -side
    for b in range(r):
        out[b] = 0.0
    out[free] = side
    big = 1.0
    for i in range(count):
        out[pivots[i]] = -side * rows[i * r + free]
        if abs(out[pivots[i]]) > big:
            big = abs(out[pivots[i]])
    for b in range(r):
        out[b] /= big
    return 0
