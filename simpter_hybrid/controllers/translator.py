"""Davis's torque translator: the achievable clutch torques nearest to the desired link torques."""


def nearest_torques(a, b, qd, rows, out):
    """Magnitudes of four clutches' torques nearest to those desired of two coordinates.

    A clutch can only oppose its slip, so it offers ``-sign(w_i) C_i`` times a non-negative
    magnitude; the magnitudes minimize the distance from ``(a, b)`` [N m]: a non-negative least
    squares of two equations, whose solutions need at most two clutches. Of several equally near
    ones with at most two clutches the one with the least sum of squares is taken.
    A clutch at exactly zero slip (stuck, or the device at rest) has no sign and is not asked for: a
    clutch that has stuck is released at the next sample, and the device is free when it starts.
    Source: thesis 2.2 ("the signs of the clutch velocities are used"; the algorithm's detail is
    lost). A clutch that is kept applied while stuck guides the tip along its own curve whatever the
    path; of the readings tried only this one comes near the path length and run time that
    Table 5's inferred parameters go with.

    Parameters
    ----------
    a, b : float
        Desired torques on links A and B [N m], or forces along two lengths [N].
    qd : array, (2,)
        Their speeds [rad/s or m/s].
    rows : array, (8,)
        Clutch map of the four clutches, row-major.
    out : array, (4,)
        Magnitudes, written [N m or N].
    """
    best = a * a + b * b
    small = 1e-12 * best
    effort = 0.0
    for k in range(4):
        out[k] = 0.0
    for i in range(4):
        # Column (xi, yi) that clutch i offers; its row of the clutch map is (ui, vi).
        ui = rows[2 * i]
        vi = rows[2 * i + 1]
        wi = ui * qd[0] + vi * qd[1]
        si = -1.0 if wi > 0.0 else 1.0 if wi < 0.0 else 0.0
        xi = si * ui
        yi = si * vi
        size = ui * ui + vi * vi
        along = (xi * a + yi * b) / size if size > 0.0 else 0.0
        if along > 0.0:
            left = (a - along * xi) ** 2 + (b - along * yi) ** 2
            if left < best - small or (left <= best + small and along * along < effort):
                best = left
                effort = along * along
                for k in range(4):
                    out[k] = along if k == i else 0.0
        for j in range(i):
            uj = rows[2 * j]
            vj = rows[2 * j + 1]
            wj = uj * qd[0] + vj * qd[1]
            sj = -1.0 if wj > 0.0 else 1.0 if wj < 0.0 else 0.0
            det = xi * sj * vj - sj * uj * yi
            if det != 0.0:
                ti = (a * sj * vj - sj * uj * b) / det
                tj = (xi * b - a * yi) / det
                if ti >= 0.0 and tj >= 0.0:
                    cost = ti * ti + tj * tj
                    if best > small or cost < effort:
                        best = 0.0
                        effort = cost
                        for k in range(4):
                            out[k] = ti if k == i else tj if k == j else 0.0
