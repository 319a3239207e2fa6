"""A mass on a spring, let go, with dry friction: its model, its map and its record."""

from pathlib import Path

import numpy as np
from axis_recordings import LET_ALONE, written

from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.recordings.recording import Recording

MASS, SPRING, FRICTION = 0.012, 0.92, 0.012
STEP, NOISE = 0.02, 0.002
#: Where each run begins [m].
FROM = (1.9, -1.6, 1.2, -2.0, 1.0, 1.5, -1.3, 1.75)
SETS = "AAAABBCC"
MODEL = f"""
[run]
t_end = "9 s"
[start]
coordinates = ["0 m"]
[device]
kind = "linear-axis"
mass = "{MASS} kg"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = {{ kind = "coulomb-viscous", coulomb = "{FRICTION} N", viscous = "0 N*s/m" }}
[[effects]]
kind = "spring-force"
coordinate = "slide"
stiffness = "{SPRING} N/m"
rest = "0 m"
[[tolerances]]
name = "spring"
parameters = ["effect.1.SpringForce.stiffness"]
relative = 0.05
[[tolerances]]
name = "friction"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.3
"""
MAP = f"""{LET_ALONE}group = ["set"]
[split]
fit = ["set A"]
select = ["set B"]
report = ["set C"]
[channels.position]
column = "x"
unit = "m"
sign = 1
role = "measured"
may_rest = true
"""


def swings(start, times):
    """Half swings about where friction and spring balance, until it stays (rows,)."""
    way, half = FRICTION / SPRING, np.pi / np.sqrt(SPRING / MASS)
    number = (times / half).astype(int)
    from_ = np.abs(start) - 2 * way * number
    moves = from_ > way
    last = max(0.0, np.abs(start) - 2 * way * np.ceil((np.abs(start) - way) / (2 * way)))
    phase = times / half - number
    course = (-1.0) ** number * (way + (from_ - way) * np.cos(np.pi * phase))
    rest = (-1.0) ** np.argmin(moves) * last if not moves.all() else 0.0
    return np.sign(start) * np.where(moves, course, rest)


def recorded(folder: Path) -> Recording:
    """Eight runs with noise, from the places `FROM`."""
    draw = np.random.default_rng(5)
    rows = ["take,set,s,x"]
    for run, (start, group) in enumerate(zip(FROM, SETS, strict=True)):
        times = STEP * np.arange(400)
        seen = swings(start, times) + draw.normal(0.0, NOISE, times.size)
        rows += [f"{run},{group},{t:.3f},{x:.5f}" for t, x in zip(times, seen, strict=True)]
    return as_axis(written(folder, rows, MAP))
