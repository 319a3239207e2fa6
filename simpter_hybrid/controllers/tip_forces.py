"""What each of four clutches does at the tip: a force, always against its slip."""

import math


def opposing_force(i, qd, jac, rows, out):
    """Tip force of a unit torque of clutch ``i`` against its slip; zero where it does not slip.

    Source: thesis equations (49)-(52), whose ``J`` takes tip forces to link torques.

    Parameters
    ----------
    i : int
        Clutch, from 0.
    qd : array, (2,)
        Speeds of the coordinates [rad/s or m/s].
    jac : array, (4,)
        Tip Jacobian, row-major [m/rad or 1].
    rows : array, (8,)
        Clutch map of the four clutches, row-major.
    out : array, (2,)
        Force per torque, written [1/m or 1].
    """
    u = rows[2 * i]
    v = rows[2 * i + 1]
    slip = u * qd[0] + v * qd[1]
    sign = -1.0 if slip > 0.0 else 1.0 if slip < 0.0 else 0.0
    det = jac[0] * jac[3] - jac[1] * jac[2]
    out[0] = sign * (u * jac[3] - v * jac[2]) / det
    out[1] = sign * (v * jac[0] - u * jac[1]) / det


def angle_between(ax, ay, bx, by):
    """Angle between two plane vectors, 0 to pi [rad].

    Parameters
    ----------
    ax, ay, bx, by : float
        Their components, in any unit.
    """
    return abs(math.atan2(ax * by - ay * bx, ax * bx + ay * by))
