"""Twelve runs of an axis moved to and fro, whose friction changes by what was logged beside."""

import numpy as np
from axis_recordings import written
from moved_axis import MAP, model

SPLIT = """
[split]
fit = ["run 0", "run 1", "run 2", "run 3", "run 4", "run 5"]
select = ["run 6", "run 7", "run 8"]
report = ["run 9", "run 10", "run 11"]
[channels.CHANNEL]
column = "y"
unit = "UNIT"
sign = 1
role = "input"
"""
NOISE = 0.05
TIME = np.arange(0.0, 6.0, 0.005)
DECLARED = model(0.3, 'coulomb = "5 N", viscous = "4 N*s/m"')


def logged_beside(folder, channel, unit, course, change, viscous=1.0):
    """Twelve runs, moved to and fro: friction is changed by what `course` of (run, time) is.

    `viscous`: what is viscous changes by this part of that.
    """
    generator, rows = np.random.default_rng(3), ["run,t,x,F,y"]
    for run in range(12):
        turn = 2 * np.pi * (0.5 + 0.1 * (run % 4))
        x, v = 0.05 * np.sin(turn * TIME + 0.3), 0.05 * turn * np.cos(turn * TIME + 0.3)
        y = course(run, TIME)
        rubs = 5.0 * np.sign(v) * (1.0 + change(y)) + 4.0 * v * (1.0 + viscous * change(y))
        force = -0.3 * turn**2 * x + rubs + generator.normal(0.0, NOISE, TIME.size)
        columns = zip(TIME, x, force, y, strict=True)
        rows += [f"{run},{a:.3f},{b:.8f},{c:.5f},{d:.4f}" for a, b, c, d in columns]
    described = MAP + SPLIT.replace("CHANNEL", channel).replace("UNIT", unit)
    return written(folder, rows, described)
