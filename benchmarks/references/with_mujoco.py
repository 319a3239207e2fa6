"""The linkage in MuJoCo: two hinged bodies, friction loss of joints and tendons.

The second hinge carries the *relative* angle, so that clutch 1 is the friction of hinge 1, clutch 3
that of hinge 2, and clutches 2 and 4 those of fixed tendons (angle B, and the sum of both angles).
The phase of the second body's centre of mass turns a double pendulum's cosine into PTER's sine.
MuJoCo's friction is a regularised one: in the stick range the force is proportional to the slip,
softened by ``solimp``. Default: that of its documentation's defaults. Hard: a constraint that would
stop the slip within one step (``solref`` direct, 1/step), softened by 1 - 1e-9. One friction level
for stick and slip, constant in speed: neither a gap nor a slope can be said.
"""

from __future__ import annotations

import math
import time

import mujoco
import numpy as np
from answer import Answer, thinned
from linkage import DEVICE, LOAD, START, T_END, TORQUES

XML = """<mujoco><compiler angle="radian" inertiafromgeom="false" balanceinertia="false"
boundmass="0" boundinertia="0"/>
<option timestep="{h!r}" gravity="0 0 0" integrator="Euler" solver="Newton" iterations="200"
tolerance="0" jacobian="dense"><flag contact="disable" refsafe="disable"/></option>
<worldbody><body><joint name="a" axis="0 0 1" {soft} frictionloss="{t[0]!r}"/>
<inertial pos="0 0 0" mass="1" diaginertia="{ia!r} {ia!r} {ia!r}"/>
<body pos="1 0 0"><joint name="r" axis="0 0 1" {soft} frictionloss="{t[2]!r}"/>
<inertial pos="0 {side} 0" mass="{mass!r}" diaginertia="{ib!r} {ib!r} {ib!r}"/></body></body>
</worldbody><tendon>
<fixed {soft} frictionloss="{t[1]!r}"><joint joint="a" coef="1"/><joint joint="r" coef="1"/></fixed>
<fixed {soft} frictionloss="{t[3]!r}"><joint joint="a" coef="2"/><joint joint="r" coef="1"/></fixed>
</tendon></mujoco>"""


#: Slip below which a clutch is taken to stick, hard [rad/s per second of step] and soft [rad/s]:
#: what a held clutch creeps.
CREEP_HARD, CREEP_SOFT = 1e-3, 1e-3
#: Settings of the friction constraint: the documented defaults, and as hard as it gets.
SOFT = 'solreffriction="0.02 1" solimpfriction="0.9 0.95 0.001"'
HARD = 'solreffriction="0 {rate!r}" solimpfriction="0.999999999 0.999999999 1"'


def model(step: float, hard: bool) -> mujoco.MjModel:
    """The linkage with a time step [s].

    A mass |gamma| on a lever of 1 m about the end of a lever of 1 m, turned by a right angle, has
    the cross term -gamma sin(q1 - q2) w1 w2; what it adds to either link's inertia is taken off.
    """
    d = DEVICE
    mass = abs(d.gamma)
    text = XML.format(
        h=step, soft=HARD.format(rate=-1.0 / step) if hard else SOFT, t=TORQUES, mass=mass,
        ia=2.0 * d.alpha - mass, ib=2.0 * d.beta - mass, side=-1 if d.gamma > 0.0 else 1,
    )  # fmt: skip
    return mujoco.MjModel.from_xml_string(text)


def solve(step: float, hard: bool = True) -> tuple[Answer, float]:
    """The run and its processor time [s]."""
    md = model(step, hard)
    data = mujoco.MjData(md)
    data.qpos[:] = [START[0], START[1] - START[0]]
    count = round(T_END / step)
    speed = np.zeros((count, 2))
    start = time.process_time()
    for k in range(count):
        f = [LOAD.first, LOAD.second]
        for j, size, rate, phase in LOAD.lines:
            f[int(j)] += size * math.sin(rate * k * step + phase)
        data.qfrc_applied[0] = f[0] + f[1]
        data.qfrc_applied[1] = f[1]
        mujoco.mj_step(md, data)
        speed[k] = data.qvel
    cpu = time.process_time() - start
    slip = speed @ np.array([[1.0, 0.0], [1.0, 1.0], [0.0, -1.0], [2.0, 1.0]]).T
    modes = np.where(
        np.abs(slip) <= (CREEP_HARD * step if hard else CREEP_SOFT), 0, np.sign(slip)
    ).astype(int)
    (qa, qr), (wa, wr) = data.qpos, data.qvel
    return Answer(np.array([qa, qa + qr, wa, wa + wr]), thinned(modes, step)), cpu
