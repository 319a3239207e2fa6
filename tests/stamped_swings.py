"""A position that decays as it swings: what it is at an instant tells whether a stamp is right."""

import numpy as np
from axis_recordings import LET_ALONE

#: Where each of three takes begins, and noise of the sensor [rad].
STARTS, NOISE = (1.9, -1.5, 1.2), 0.001
MAP = f"""{LET_ALONE}[channels.position]
column = "angle"
unit = "rad"
sign = 1
role = "measured"
"""


def seen(start, taken, draw):
    """Angles with noise at the instants at which they were taken."""
    angle = start * np.exp(-0.1 * taken) * np.cos(8.0 * taken)
    return angle + draw.normal(0.0, NOISE, taken.size)
