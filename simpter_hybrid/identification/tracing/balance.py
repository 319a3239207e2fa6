"""Two torque balances that tell a sensor, the friction and the load from each other.

Sensor balance: measured minus predicted clutch torque.  Rotor balance: applied torque minus inertia
times measured acceleration minus measured clutch torque; no friction model enters it, so what is
left there is load, inertia, or the gain of a sensor, and never friction.
"""

from __future__ import annotations

import numpy as np

from ..fitting.masks import widened
from ..recordings.row_step import row_step
from ..recordings.smoothing import hann_smoothed

#: Width of the smoothing kernel [s]: the acceleration's noise is then below that of the torques.
WIDTH = 0.06
#: An inertia torque above this many standard deviations of the transmitted torque is a transient in
#: which half a sample between the stamps of two torques matters more than any load.
TRANSIENT = 15.0


def rotor_balance(
    time: np.ndarray,
    speed: np.ndarray,
    applied: np.ndarray,
    transmitted: np.ndarray,
    inertia: float,
    sd: float,
) -> np.ndarray:
    """Applied - inertia * acceleration - transmitted, all through one kernel (samples,) [N*m].

    Parameters
    ----------
    time, speed, applied, transmitted : ndarray (samples,)
        Record of one run [s, rad/s, N*m, N*m].
    inertia : float
        Declared [kg*m^2].
    sd : float
        Standard deviation of the transmitted torque [N*m].

    Returns
    -------
    ndarray (samples,)
        Zero within a kernel's width of a transient and of the ends: nothing can be said there.
    """
    step = row_step(time)
    torque = hann_smoothed(applied - transmitted, step, WIDTH)
    accelerates = inertia * np.gradient(hann_smoothed(speed, step, WIDTH), step)
    wide = max(1, round(WIDTH / step))
    silent = widened(np.abs(accelerates) > TRANSIENT * sd, wide)
    silent[:wide] = silent[-wide:] = True
    return np.where(silent, 0.0, torque - accelerates)
