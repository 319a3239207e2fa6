"""Appendix A: the torques that hold PTER's stuck clutches, Cases 2 to 6, as corrected.

``f`` (2,) is the external torque on the links less the velocity terms, so that the printed
``tau_in - V`` is one number; the printed (55)-(59) lose ``-(M12/M22) V2`` and ``-(M21/M11) V1``,
and (66) exchanges the two torques.  ``tau`` (4,) holds the torques of the other clutches.
"""


def single(i, M, f, tau):
    """Torque that keeps clutch ``i`` (from 0) stuck while the others slip: (55)-(63) [N m]."""
    if i == 0:
        r = M[1] / M[3]
        return r * tau[1] - (r + 1.0) * tau[2] + (r - 1.0) * tau[3] + r * f[1] - f[0]
    if i == 1:
        # The printed (58) gives tau_3 the sign it has in (55); on link B it is the other one.
        r = M[2] / M[0]
        return r * tau[0] + (r + 1.0) * tau[2] + (r - 1.0) * tau[3] + r * f[0] - f[1]
    if i == 2:
        a = M[0] + M[1]
        b = M[2] + M[3]
        return (b * (-tau[0] - f[0]) + a * (tau[1] + f[1]) + (a - b) * tau[3]) / (a + b)
    a = M[0] - M[1]
    b = M[3] - M[2]
    return (b * (tau[0] + f[0]) + a * (tau[1] + f[1]) + (b - a) * tau[2]) / -(a + b)


def pair(i, j, f, tau):
    """Torques of two stuck clutches ``i < j`` with everything at rest: (66)-(77), into ``tau``.

    They stop the links; the clutches of ``tau`` that are not applied must be zero.
    """
    if i == 0 and j == 1:
        tau[0] = -f[0]
        tau[1] = -f[1]
    elif i == 0 and j == 2:
        tau[2] = f[1]
        tau[0] = -f[0] - f[1]
    elif i == 0:
        tau[3] = -f[1]
        tau[0] = -f[0] + f[1]
    elif i == 1 and j == 2:
        tau[2] = -f[0]
        tau[1] = -f[0] - f[1]
    elif i == 1:
        tau[3] = -f[0]
        tau[1] = f[0] - f[1]
    else:
        tau[3] = -0.5 * (f[0] + f[1])
        tau[2] = 0.5 * (f[1] - f[0])
