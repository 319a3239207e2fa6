"""How finely a record is played: in steps, as many as its rows need.

What drives and presses a model is constant from one sample of its controller to the next.  A model
may sample far more often than its record has rows: each step takes as long as any other, and tells
nothing that the rows do not hold.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

#: An input that goes on between its rows is played in so many steps for each, none longer [s].
#: Of a slide with rows of 2 ms two steps a row end at the same error as four (0.985 times the floor
#: of its nulls); of a spindle that sticks one a row does, too.
STEPS, LONGEST = 2, 2.5e-3
#: Where nothing changes steps bound those of the integrator: at its tolerance alone a force of 1250
#: rad/s along a coast-down was 2e-4 rad off.
IDLE = 1e-2
#: Rows are even if none is off by more than this part of a step.
OFF = 0.01
#: What changes within rows is played in at most so many steps a row: a shift is known no better.
FINEST = 20


def played_every(
    time: np.ndarray, declared: float, changes: bool, held: bool, shifts: Sequence[float] = ()
) -> float:
    """How often a record is played [s]: never more often than `declared`.

    Parameters
    ----------
    time : ndarray (samples,)
        [s], from 0 on.
    declared : float
        Period of the model's controller [s].
    changes : bool
        Whether any input does.
    held : bool
        Whether what changes is constant from row to row; else it goes on between them.
    shifts : sequence of float
        How long after its rows' stamps each held input changes [s].
    """
    if time.size < 2:
        return declared
    step = float(time[-1]) / (time.size - 1)
    if not changes:
        return max(declared, min(step, IDLE))
    if np.abs(time - step * np.arange(time.size)).max() > OFF * step:
        return declared  # a step would be partly of one row and partly of the next
    steps = 1 if held else max(STEPS, int(np.ceil(step / LONGEST)))
    if any(shifts):
        parts = np.array(shifts) / step
        within = (n * parts for n in range(steps, FINEST + 1))
        fitting = (n for n, at in enumerate(within, steps) if np.all(abs(at - np.round(at)) <= OFF))
        steps = next(fitting, max(steps, FINEST))
    return max(declared, step / steps)
