"""The stick margin: how far a stuck set is from letting go.

The torques that a stuck set can hold form a zonotope.  In the coordinates of its independent rows
(C_i = a_i C_R) the load to be held is ``lam``; each facet normal y is orthogonal to r-1
independent a's, and the margin of the facet is the most that the set can give along y less what is
asked for.  For an independent set this is the breakaway torque less the holding torque of each
clutch; for a redundant one it is exact where no unique holding torques exist.
Source: facets of a zonotope, its generators being bounded torques; thesis Appendix A, Case 7.
"""

from .linear import null_vector, solve_many
from .records import STICK


def coefficients(C, n, m, rows, cols, r, a, s):
    """``a`` (m, r): row i of the clutch map as a combination of the independent stuck rows.

    Only rows in their span are represented; others are filled as if projected on ``cols[:r]``.
    """
    if r == 0:
        return 0
    # Solve C_RD^T a_i = C_iD for all clutches at once: right-hand sides are columns.
    at = r * r
    for d in range(r):
        for e in range(r):
            s[d * r + e] = C[rows[e] * n + cols[d]]
        for i in range(m):
            s[at + d * m + i] = C[i * n + cols[d]]
    right = s[at : at + r * m]
    status = solve_many(s, right, r, m)
    for i in range(m):
        for d in range(r):
            a[i * r + d] = right[d * m + i]
    for e in range(r):
        for d in range(r):
            a[rows[e] * r + d] = 1.0 if d == e else 0.0
    return status


def facets(m, mode, r, a, limit, constant, y, p, pick, pivots, s):
    """Facet normals of a stuck set.

    Writes ``y`` (limit, r) and the slip pattern ``p`` (limit, m) with p_i = a_i . y, scaled so that
    the largest |p_i| is 1.  Returns the number of facets, or -1 when there are more than ``limit``.
    Where the clutch map is not ``constant`` every choice of r-1 rows keeps its number, though in
    some poses it has the facet of another or none (zeros): guards have to go on as they were.
    """
    stuck = 0
    for i in range(m):
        if mode[i] == STICK:
            pick[r + stuck] = i
            stuck += 1
    count = 0
    for d in range(r - 1):
        pick[d] = d
    going = r > 0
    while going:
        for d in range(r - 1):
            for e in range(r):
                s[d * r + e] = a[pick[r + pick[d]] * r + e]
        normal = s[r * r : r * r + r]
        found = null_vector(s, r - 1, r, pivots, normal) == 0
        if found or not constant:
            if count == limit:
                return -1
            big = 0.0
            for i in range(m):
                total = 0.0
                if found and mode[i] == STICK:
                    for e in range(r):
                        total += a[i * r + e] * normal[e]
                    if abs(total) < 1e-9:
                        total = 0.0
                p[count * m + i] = total
                if abs(total) > big:
                    big = abs(total)
            for i in range(m):
                p[count * m + i] /= big if found else 1.0
            for e in range(r):
                y[count * r + e] = normal[e] / big if found else 0.0
            if not constant or not repeated(m, count, p):
                count += 1
        going = next_subset(pick, r - 1, stuck)
    return count


def next_subset(pick, size, stuck):
    """Move on to the next subset of that size in lexicographic order; False after the last."""
    d = size - 1
    while d >= 0 and pick[d] == stuck - size + d:
        d -= 1
    if d < 0:
        return False
    pick[d] += 1
    for e in range(d + 1, size):
        pick[e] = pick[e - 1] + 1
    return True


def repeated(m, count, p):
    """Whether facet ``count`` has the slip pattern of an earlier one, up to its sign."""
    for k in range(count):
        same = True
        mirrored = True
        for i in range(m):
            if abs(p[k * m + i] - p[count * m + i]) > 1e-9:
                same = False
            if abs(p[k * m + i] + p[count * m + i]) > 1e-9:
                mirrored = False
        if same or mirrored:
            return True
    return False


def facet_margin(m, r, k, sign, y, p, lam, fr):
    """Margin of facet ``k`` [N m]: what the set can give along ``sign * y`` less what is asked.

    In a pose in which there is no such facet the sum of what all clutches can hold, which no other
    margin exceeds.
    ``fr`` holds the friction torques in blocks of m: slip now, breakaway forward and backward,
    slip at 0+ forward and backward.  A positive torque opposes backward slip.
    """
    total = 0.0
    there = False
    for i in range(m):
        pi = sign * p[k * m + i]
        if pi > 0.0:
            total += pi * fr[2 * m + i]
            there = True
        elif pi < 0.0:
            total -= pi * fr[m + i]
            there = True
    if not there:
        for i in range(m):
            total += fr[2 * m + i]
    for e in range(r):
        total -= sign * y[k * r + e] * lam[e]
    return total


def share(m, mode, r, a, lam, fr, tau, fixed, s):
    """Distribute ``lam`` over a stuck set: least sum of (tau_i/tau_break_i)^2, within the limits.

    A stated convention where the set is redundant; the unique torques where it is not.  Writes the
    stuck entries of ``tau`` and leaves the others alone.  ``fixed`` (m,): 1 and -1 where a torque
    is at its limit above and below, 2 where it exceeds one because the set cannot hold the load.
    Source: Goldfarb and Idnani 1983 (dual active sets), the limits being the only constraints.
    """
    least = 0.0
    for i in range(m):
        fixed[i] = 0
        if mode[i] == STICK:
            half = 0.5 * (fr[m + i] + fr[2 * m + i])
            least += 1e-12 * (half * half)
    if least == 0.0:
        least = 1.0
    x = s[r * r : r * r + r]
    dx = s[r * r + r : r * r + 2 * r]
    for _ in range(8 * m + 8):
        if balance(m, mode, r, a, lam, fr, least, tau, fixed, x, s) != 0:
            return 1
        over = most_overloaded(m, mode, fr, tau, fixed)
        if over < 0:
            return 0
        relieve(m, mode, r, a, fr, least, tau, fixed, over, x, dx, s)
    return 0


def weight_of(m, i, fr, least):
    """Weight of a clutch's share: its breakaway torque squared.

    One without friction has a weight as well, a trillionth of all: with none the sum could not be
    solved, and what the others hold is theirs whatever it can hold.
    """
    half = 0.5 * (fr[m + i] + fr[2 * m + i])
    return max(half * half, least)  # a power would raise where this is infinite


def add_weights(m, mode, r, a, fr, least, fixed, s):
    """``s`` (r, r): what the torques not fixed give along each other's rows."""
    for d in range(r * r):
        s[d] = 0.0
    for i in range(m):
        if mode[i] == STICK and abs(fixed[i]) != 1:
            weight = weight_of(m, i, fr, least)
            for d in range(r):
                for e in range(r):
                    s[d * r + e] += weight * a[i * r + d] * a[i * r + e]


def balance(m, mode, r, a, lam, fr, least, tau, fixed, x, s):
    """Torques beside those that are fixed at a limit; ``x`` (r,): multipliers of the load."""
    for d in range(r):
        x[d] = lam[d]
    for i in range(m):
        if mode[i] == STICK and abs(fixed[i]) == 1:
            tau[i] = fr[2 * m + i] if fixed[i] > 0 else -fr[m + i]
            for d in range(r):
                x[d] -= a[i * r + d] * tau[i]
    add_weights(m, mode, r, a, fr, least, fixed, s)
    if solve_many(s, x, r, 1) != 0:
        return 1
    for i in range(m):
        if mode[i] == STICK and abs(fixed[i]) != 1:
            total = 0.0
            for d in range(r):
                total += a[i * r + d] * x[d]
            tau[i] = total * weight_of(m, i, fr, least)
    return 0


def most_overloaded(m, mode, fr, tau, fixed):
    """The stuck clutch whose torque exceeds its limit most, by more than rounding; -1: none.

    One without friction has no share worth the name, unless the load is more than the set can hold.
    """
    worst = 1.0 + 1e-12
    where = -1
    for i in range(m):
        if mode[i] == STICK and fixed[i] == 0:
            bound = fr[2 * m + i] if tau[i] > 0.0 else fr[m + i]
            if bound > 0.0 and abs(tau[i]) > worst * bound:
                worst = abs(tau[i]) / bound
                where = i
    return where


def relieve(m, mode, r, a, fr, least, tau, fixed, over, x, dx, s):
    """Bring the torque of clutch ``over`` to its limit, the others taking over what it leaves.

    One that is at its limit and would take its share back on the way is set free.  Where nothing
    takes over, the load is more than the set can hold, and ``over`` is left to bear it.
    """
    side = 1 if tau[over] > 0.0 else -1
    weight = weight_of(m, over, fr, least)
    excess = tau[over] - fr[2 * m + over] if side > 0 else -tau[over] - fr[m + over]
    while fixed[over] == 0:
        add_weights(m, mode, r, a, fr, least, fixed, s)
        for d in range(r):
            dx[d] = side * weight * a[over * r + d]
        solve_many(s, dx, r, 1)
        left = 1.0
        for d in range(r):
            left -= side * a[over * r + d] * dx[d]
        # Nobody moves beside one that all but rounding is left to.
        step = excess / (weight * left) if left > 1e-9 else 1e300
        back = -1
        for i in range(m):
            if mode[i] == STICK and abs(fixed[i]) == 1:
                pull = -fixed[i] * tau[i] / weight_of(m, i, fr, least)
                rate = 0.0
                for d in range(r):
                    pull += fixed[i] * a[i * r + d] * x[d]
                    rate -= fixed[i] * a[i * r + d] * dx[d]
                if rate > 0.0 and max(pull, 0.0) < step * rate:
                    step = max(pull, 0.0) / rate
                    back = i
        if back >= 0:
            for d in range(r):
                x[d] += step * dx[d]
            excess -= step * weight * max(left, 0.0)
            fixed[back] = 0
        else:
            fixed[over] = side if step < 1e300 else 2
