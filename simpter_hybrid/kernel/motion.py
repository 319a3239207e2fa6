"""The flow of a mode and its guards.

State ``y = [q (n), qd (n), excitation (m), effect states (nz), ledger (2 + m)]``; the ledger holds
the work of the load, the work of the effects' forces, and the energy dissipated by each clutch [J].
"""

from .margin import coefficients, facet_margin, facets, share
from .records import BACKWARD, FACET_LIMIT, FORWARD, FREE, ON
from .reduction import (
    accelerations,
    choose_columns,
    dependence,
    held_force,
    partition,
    project_speeds,
    take_slip,
)

#: What ``guards`` writes where no guard applies; no true guard takes this value.
NEVER = 1e300


def enter_mode(md, y, w):
    """Prepare the present mode: partition, constraint on ``y``, facets.  Returns a status.

    0 fine, 3 singular partition, 4 too many facets.
    """
    n = md.n
    m = md.m
    md.map(y, md.p, w.C)
    r = partition(w.C, n, m, w.mode, w.rows, w.cols, w.s)
    w.meta[0] = r
    w.meta[1] = 0
    if r == 0:
        return 0
    if dependence(w.C, n, w.rows, w.cols, r, w.B, w.s) != 0:
        return 3
    project_speeds(y, n, w.cols, r, w.B)
    return find_facets(md, w)


def find_facets(md, w):
    """Facets of the present stuck set at the present clutch map (in ``w.C``)."""
    r = w.meta[0]
    if coefficients(w.C, md.n, md.m, w.rows, w.cols, r, w.a, w.s) != 0:
        return 3
    count = facets(
        md.m, w.mode, r, w.a, FACET_LIMIT, md.constant, w.fy, w.fp, w.pick, w.pivots, w.s
    )
    if count < 0:
        return 4
    w.meta[1] = count
    return 0


def constrain(md, y, w):
    """Give the dependent speeds in ``y`` the values the stuck set leaves them."""
    r = w.meta[0]
    if r > 0:
        if not md.constant:
            md.map(y, md.p, w.C)
            choose_columns(w.C, md.n, w.rows, w.cols, r, w.s)
            dependence(w.C, md.n, w.rows, w.cols, r, w.B, w.s)
            take_slip(y, md.n, w.C, w.rows, r, w.s)
        project_speeds(y, md.n, w.cols, r, w.B)


def evaluate(md, t, y, w):
    """Everything at (t, y) in the present mode: ``w.f`` (with slip torques), ``w.qdd``, ``w.tau``.

    ``y`` must satisfy the constraint (``constrain``).  Stuck entries of ``w.tau`` are left alone.
    """
    n = md.n
    md.terms(t, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)
    for i in range(md.m):
        if w.mode[i] == FORWARD or w.mode[i] == BACKWARD:
            w.tau[i] = -w.mode[i] * w.fr[i]
            for j in range(n):
                w.f[j] += w.C[i * n + j] * w.tau[i]
        elif w.mode[i] == FREE:
            w.tau[i] = 0.0
    return accelerations(
        w.M, w.f, w.C, w.c, n, w.rows, w.cols, w.meta[0], w.B, md.constant, w.qdd, w.s
    )


def hold(md, w):
    """Holding torques of the stuck set after ``evaluate``: ``w.lam``; ``w.tau`` by ``share``."""
    r = w.meta[0]
    if r > 0:
        held_force(w.M, w.f, w.C, md.n, w.rows, w.cols, r, w.qdd, w.lam, w.s)
        if not md.constant:
            coefficients(w.C, md.n, md.m, w.rows, w.cols, r, w.a, w.s)
        share(md.m, w.mode, r, w.a, w.lam, w.fr, w.tau, w.state, w.s)


def place(md, y, w):
    """Copy ``y`` to ``w.yv`` without its ledger, on which nothing depends, and constrain it."""
    for i in range(md.ny - md.m - 2):
        w.yv[i] = y[i]
    constrain(md, w.yv, w)


def flow(md, t, y, w, dy):
    """Right-hand side of the present mode; ``y`` is left alone.  Returns a status."""
    n = md.n
    m = md.m
    place(md, y, w)
    status = 0
    w.meta[2] = 0
    if w.meta[0] == n and md.constant and not md.feedback:
        # Locked: nothing accelerates, and no force does work.
        w.meta[2] = 1
        for j in range(n):
            w.qdd[j] = 0.0
            w.Q[j] = 0.0
            w.Q[n + j] = 0.0
    else:
        status = evaluate(md, t, w.yv, w)
    if md.feedback:
        hold(md, w)
    load = 0.0
    effects = 0.0
    for j in range(n):
        qd = w.yv[n + j]
        dy[j] = qd
        dy[n + j] = w.qdd[j]
        load += w.Q[j] * qd
        effects += w.Q[n + j] * qd
    md.rates(t, w.yv, md.p, md.rec, w.held, w.mode, w.gate, w.dmode, w.tau, w.C, w.s, dy)
    ledger = md.ny - m - 2
    dy[ledger] = load
    dy[ledger + 1] = effects
    for i in range(m):
        power = 0.0
        if w.mode[i] == FORWARD or w.mode[i] == BACKWARD:
            for j in range(n):
                power -= w.tau[i] * w.C[i * n + j] * w.yv[n + j]
        dy[ledger + 2 + i] = power
    return status


def guards(md, t, y, w, out):
    """Guard values of the present mode, positive while it may go on.  Returns how many.

    Layout: slip guards (m), off guards (m), the model's own (ng), facet margins (2 a facet).
    Entries that do not apply are ``NEVER``.
    """
    place(md, y, w)
    if w.meta[0] > 0:
        evaluate(md, t, w.yv, w)
    elif not md.constant:
        md.map(w.yv, md.p, w.C)
    return read_guards(md, t, w, out)


def guards_after_flow(md, t, w, out):
    """``guards`` where ``flow`` has just been: its inertia, loads and friction serve again."""
    if w.meta[2] == 1:
        evaluate(md, t, w.yv, w)
    return read_guards(md, t, w, out)


def read_guards(md, t, w, out):
    """Guard values from what has been evaluated at (t, ``w.yv``)."""
    slip_guards(md, t, w, out)
    return load_guards(md, t, w, out)


def slip_guards(md, t, w, out):
    """Slip and off guards, which need the clutch map only."""
    n = md.n
    m = md.m
    for i in range(m):
        out[i] = NEVER
        if (w.mode[i] == FORWARD or w.mode[i] == BACKWARD) and md.smooth[i] == 0:
            slip = 0.0
            for j in range(n):
                slip += w.C[i * n + j] * w.yv[n + j]
            # Let go at this instant: zero by algebra, whatever the rounding of the sum.
            new = w.released[i] != 0 and t == w.stamp[0]
            out[i] = 0.0 if new else w.mode[i] * slip
        out[m + i] = NEVER
        if w.gate[i] == ON and w.held[i] <= md.threshold[i]:
            out[m + i] = w.yv[2 * n + i] - md.threshold[i]


def load_guards(md, t, w, out):
    """The model's own guards and the margins of the stuck set.  Returns the count of all."""
    n = md.n
    m = md.m
    if md.ng > 0:
        md.watch(t, w.yv, md.p, md.rec, w.held, w.mode, w.dmode, w.s, out)
    count = 2 * m + md.ng
    r = w.meta[0]
    if r > 0:
        held_force(w.M, w.f, w.C, n, w.rows, w.cols, r, w.qdd, w.lam, w.s)
        if not md.constant:
            find_facets(md, w)
        for k in range(w.meta[1]):
            out[count] = facet_margin(m, r, k, 1.0, w.fy, w.fp, w.lam, w.fr)
            out[count + 1] = facet_margin(m, r, k, -1.0, w.fy, w.fp, w.lam, w.fr)
            count += 2
    return count
