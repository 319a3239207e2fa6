"""Where a rotor that is driven by torque strikes the end of a play: what follows tells too little.

An engaged clutch that transmits nothing while its rotor moves has a play.  The instant at which
that ends is known as well as the speed that was set from the record, and every contact after it
worse, while each transmits much for a few samples: compared sample by sample, a right model errs
there by many times the noise.  Until the rotor rests again these samples are left out.
"""

from __future__ import annotations

import numpy as np

from ..recordings.row_step import row_step
from ..recordings.smoothing import moving_mean
from ..recordings.stretches import stretches
from .conditioning import MEAN, RESTS_BELOW

#: Slow for so long it rests [s].
RESTED = 0.05
#: A torque below so many deviations of a mean of `MEAN` samples is none, and a speed above moves.
NOTHING = 4.0
#: Samples in a play that show it, and samples before its end from which nothing is compared.
LEAST, EARLY = 4, 5
#: Torque at the end of a play, in its sd, and samples in which it is reached: an excitation that
#: rises after a command takes longer.
STRIKES, WITHIN = 10.0, 5


def struck(
    time: np.ndarray,
    speed: np.ndarray,
    torque: np.ndarray,
    command: np.ndarray,
    noise: tuple[float, float],
) -> np.ndarray:
    """Samples (samples,) of bool that follow the end of a play, until the rotor rests.

    Parameters
    ----------
    time, speed, torque, command : ndarray (samples,)
        Of one run driven by torque.
    noise : tuple of float
        Standard deviations of speed and torque.
    """
    step = row_step(time)
    index = np.arange(time.size)
    moves = np.abs(moving_mean(speed, MEAN)) > RESTS_BELOW * noise[0] / np.sqrt(MEAN)
    empty = np.abs(moving_mean(torque, MEAN)) < NOTHING * noise[1] / np.sqrt(MEAN)
    moved = np.maximum.accumulate(np.where(moves, index, -index.size))
    resting = index - moved >= round(RESTED / step)
    found = np.zeros(time.size, bool)
    for one in stretches((command > 0.0) & moves & empty):
        begin, end = one.start, one.stop
        strikes = np.abs(torque[end : end + WITHIN]).max(initial=0.0) > STRIKES * noise[1]
        if end - begin >= LEAST and strikes:
            rest = end + int(np.argmax(resting[end:])) if resting[end:].any() else time.size
            found[max(end - EARLY, 0) : rest] = True
    return found
