"""Davis's torque translator: the achievable clutch torques nearest to the desired link torques."""


def nearest_torques(a, b, qd, out):
    """Torque magnitudes of PTER's clutches nearest to desired link torques.

    A clutch can only oppose its slip, so it offers ``-sign(w_i) C_i`` times a non-negative
    magnitude; the magnitudes minimize the distance from ``(a, b)`` [N m]: a non-negative least
    squares of two equations, whose solutions need at most two clutches. Among equally near ones the
    least sum of squares is taken. A clutch at exactly zero slip can hold either way and is taken to
    act in the direction that helps.
    Source: thesis 2.2 (the algorithm's detail is lost; this is the reading stated here).

    Parameters
    ----------
    a, b : float
        Desired torques on links A and B [N m].
    qd : array, (2,)
        Link speeds [rad/s].
    out : array, (4,)
        Magnitudes, written [N m].
    """
    u0 = 1.0
    v0 = 0.0
    w0 = qd[0]
    u1 = 0.0
    v1 = 1.0
    w1 = qd[1]
    u2 = 1.0
    v2 = -1.0
    w2 = qd[0] - qd[1]
    u3 = 1.0
    v3 = 1.0
    w3 = qd[0] + qd[1]
    # Column (x, y) that each clutch offers.
    s0 = -1.0 if w0 > 0.0 or (w0 == 0.0 and u0 * a + v0 * b < 0.0) else 1.0
    s1 = -1.0 if w1 > 0.0 or (w1 == 0.0 and u1 * a + v1 * b < 0.0) else 1.0
    s2 = -1.0 if w2 > 0.0 or (w2 == 0.0 and u2 * a + v2 * b < 0.0) else 1.0
    s3 = -1.0 if w3 > 0.0 or (w3 == 0.0 and u3 * a + v3 * b < 0.0) else 1.0
    best = a * a + b * b
    small = 1e-12 * best
    effort = 0.0
    for k in range(4):
        out[k] = 0.0
    for i in range(4):
        xi = s0 * u0 if i == 0 else s1 * u1 if i == 1 else s2 * u2 if i == 2 else s3 * u3
        yi = s0 * v0 if i == 0 else s1 * v1 if i == 1 else s2 * v2 if i == 2 else s3 * v3
        along = (xi * a + yi * b) / (xi * xi + yi * yi)
        if along > 0.0:
            left = (a - along * xi) ** 2 + (b - along * yi) ** 2
            if left < best - small or (left <= best + small and along * along < effort):
                best = left
                effort = along * along
                for k in range(4):
                    out[k] = along if k == i else 0.0
        for j in range(i):
            xj = s0 * u0 if j == 0 else s1 * u1 if j == 1 else s2 * u2
            yj = s0 * v0 if j == 0 else s1 * v1 if j == 1 else s2 * v2
            det = xi * yj - xj * yi
            if det != 0.0:
                ti = (a * yj - xj * b) / det
                tj = (xi * b - a * yi) / det
                if ti >= 0.0 and tj >= 0.0:
                    cost = ti * ti + tj * tj
                    if best > small or cost < effort:
                        best = 0.0
                        effort = cost
                        for k in range(4):
                            out[k] = ti if k == i else tj if k == j else 0.0
