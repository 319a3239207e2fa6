"""A rotor that was spun up and let alone, and that nothing but friction slows."""

import numpy as np
from axis_recordings import MODEL as DRIVEN
from axis_recordings import written

from simpter_hybrid.files.scenario_file import parse

INERTIA, COULOMB, VISCOUS, NOISE = 0.02, 0.05, 0.004, 0.02
WEIGHT = 'weight = "0.5 N*m"\n'
#: The axis of other tests with less friction, no motor and no controller.
LOADS, TOLERANCES = DRIVEN.index("[[loads]]"), DRIVEN.index("[[tolerances]]")
BARE = DRIVEN[:LOADS] + DRIVEN[TOLERANCES:]
MODEL = BARE.replace("0.2 N*m", "0.05 N*m").replace("0.02 N*m*s", "0.004 N*m*s")
MAP = """
driven = false
[time]
column = "s"
unit = "s"
[runs]
boundaries = ["run"]
group = ["run"]
[channels.speed]
column = "rate"
unit = "rad/s"
sign = 1
role = "measured"
"""
POSITION = '[channels.position]\ncolumn = "angle"\nunit = "rad"\nsign = 1\nrole = "measured"\n'


def coasting(time, first):
    """Speed of a rotor that Coulomb and viscous friction slow."""
    rest, fade = COULOMB / VISCOUS, np.exp(-VISCOUS / INERTIA * time)
    return (first + rest) * fade - rest


def logged(folder, map_text=MAP):
    """Four runs of it; the map tells which of their columns are read."""
    time = np.arange(0.0, 4.0, 0.01)
    generator, rows = np.random.default_rng(4), ["run,s,rate,angle,torque"]
    for run, first in enumerate((40.0, 60.0, 50.0, 45.0)):
        speed = coasting(time, first)
        angle = np.cumsum(speed) * 0.01
        seen = speed + NOISE * generator.standard_normal(time.size)
        for t, v, q in zip(time, seen, angle, strict=True):
            rows.append(f"{run},{t:.2f},{v:.5f},{q:.6f},0")
    return written(folder, rows, map_text)


def declared():
    """What is known of it: no weight."""
    return parse(MODEL.replace(WEIGHT, ""))
