"""One clutch that turns the tip's velocity: the common half of the two velocity controllers."""

import math

from .tip_forces import angle_between, opposing_force


def steer(heading, off, angle, outward, qd, jac, rows, gain, lock_torque, held, at, unit):
    """Write the desired clutch torques that turn the tip's velocity towards a heading.

    The clutch is the one whose tip force points towards the path and makes the smallest angle with
    the desired velocity; its torque is ``gain f_N |angle|`` (53), with the angle from the tip's
    velocity to the desired one and f_N the part of its unit force normal to the path. If no clutch
    pushes towards the path, clutches 1 and 2 lock the tip when the operator pushes outward, and
    all clutches are released otherwise; on the path itself nothing is outward.
    Source: thesis 5.5.1. Which two clutches lock is not printed: 1 and 2 are, here, because they
    fix both links to ground and hold in every pose.

    Parameters
    ----------
    heading : float
        Angle between the desired velocity and the path, positive on the path's left [rad].
    off : float
        Signed distance of the tip from the path, positive on its left [m].
    angle : float
        Direction of the path from the x axis [rad].
    outward : bool
        Whether the operator's force points away from the path.
    qd : array, (2,)
        Link speeds [rad/s].
    jac : array, (4,)
        Tip Jacobian, row-major [m/rad].
    rows : array, (8,)
        Clutch map of the four clutches, row-major.
    gain : float
        K_tau [N m^2/rad].
    lock_torque : float
        Desired torque that asks for full voltage [N m].
    held : array
        Held inputs; the desired torques [N m] are written here.
    at : int
        Index in ``held`` of the first desired torque.
    unit : array, (2,)
        Scratch.
    """
    tx = math.cos(angle)
    ty = math.sin(angle)
    vx = jac[0] * qd[0] + jac[1] * qd[1]
    vy = jac[2] * qd[0] + jac[3] * qd[1]
    onward = 1.0 if vx * tx + vy * ty >= 0.0 else -1.0
    inward = -1.0 if off > 0.0 else 1.0 if off < 0.0 else 0.0
    wx = math.cos(heading) * onward * tx + math.sin(heading) * ty
    wy = math.cos(heading) * onward * ty - math.sin(heading) * tx
    chosen = -1
    nearest = 4.0
    push = 0.0
    for i in range(4):
        held[at + i] = 0.0
        opposing_force(i, qd, jac, rows, unit)
        towards = inward * (unit[1] * tx - unit[0] * ty)
        apart = angle_between(unit[0], unit[1], wx, wy)
        if towards > 0.0 and apart < nearest:
            chosen = i
            nearest = apart
            push = towards
    if chosen >= 0:
        held[at + chosen] = gain * push * angle_between(vx, vy, wx, wy)
    elif outward:
        held[at] = lock_torque
        held[at + 1] = lock_torque
