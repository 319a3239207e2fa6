"""Dormand-Prince 4(5), the pair behind SIMULINK's ode45 (variable step) and ode5 (fixed step)."""

from .flow import flow


def take_step(md, o, t, y, h, w):
    """One step of size ``h``; ``w.k1`` holds the derivative at ``t``.

    Writes ``w.y_new`` and ``w.k7``, the derivative there.  Returns a status.
    """
    k1, k2, k3, k4, k5, k6, z = w.k1, w.k2, w.k3, w.k4, w.k5, w.k6, w.y_try
    ny = md.ny
    for j in range(ny):
        z[j] = y[j] + h * 0.2 * k1[j]
    status = flow(md, o, t + 0.2 * h, z, w, k2)
    for j in range(ny):
        z[j] = y[j] + h * (3.0 / 40.0 * k1[j] + 9.0 / 40.0 * k2[j])
    status += flow(md, o, t + 0.3 * h, z, w, k3)
    for j in range(ny):
        z[j] = y[j] + h * (44.0 / 45.0 * k1[j] - 56.0 / 15.0 * k2[j] + 32.0 / 9.0 * k3[j])
    status += flow(md, o, t + 0.8 * h, z, w, k4)
    for j in range(ny):
        z[j] = y[j] + h * (
            19372.0 / 6561.0 * k1[j] - 25360.0 / 2187.0 * k2[j] + 64448.0 / 6561.0 * k3[j]
            - 212.0 / 729.0 * k4[j]
        )  # fmt: skip
    status += flow(md, o, t + 8.0 / 9.0 * h, z, w, k5)
    for j in range(ny):
        z[j] = y[j] + h * (
            9017.0 / 3168.0 * k1[j] - 355.0 / 33.0 * k2[j] + 46732.0 / 5247.0 * k3[j]
            + 49.0 / 176.0 * k4[j] - 5103.0 / 18656.0 * k5[j]
        )  # fmt: skip
    status += flow(md, o, t + h, z, w, k6)
    for j in range(ny):
        w.y_new[j] = y[j] + h * (
            35.0 / 384.0 * k1[j] + 500.0 / 1113.0 * k3[j] + 125.0 / 192.0 * k4[j]
            - 2187.0 / 6784.0 * k5[j] + 11.0 / 84.0 * k6[j]
        )  # fmt: skip
    return status + flow(md, o, t + h, w.y_new, w, w.k7)


def error_of(o, y, h, w):
    """Largest local error in units of the tolerance, as ode45 weighs it.

    The ledger of work is no state of the simulator and has no say.
    """
    worst = 0.0
    for j in range(o.span):
        e = (
            71.0 / 57600.0 * w.k1[j] - 71.0 / 16695.0 * w.k3[j] + 71.0 / 1920.0 * w.k4[j]
            - 17253.0 / 339200.0 * w.k5[j] + 22.0 / 525.0 * w.k6[j] - 1.0 / 40.0 * w.k7[j]
        )  # fmt: skip
        size = max(abs(y[j]), abs(w.y_new[j]))
        scaled = abs(h * e) / max(o.rtol * size, o.atol)
        # "not <=": a NaN is the worst error.
        if not scaled <= worst:
            worst = scaled
    return worst


def hermite(ny, y, h, w, x, out):
    """State at the fraction ``x`` of the step just taken, by cubic Hermite interpolation."""
    for j in range(ny):
        dy = w.y_new[j] - y[j]
        f1 = h * w.k1[j] - dy
        f2 = 2.0 * dy - h * (w.k7[j] + w.k1[j])
        out[j] = y[j] + x * (dy + (1.0 - x) * (f1 + x * f2))
