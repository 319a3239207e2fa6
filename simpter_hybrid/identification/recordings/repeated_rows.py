"""Rows that repeat the one before while a thing moves on: lost frames, a sensor slower than a log.

What stands still repeats its number, and so does what moves slower than its sensor's steps.  A row
that was not read anew shows by what follows: the next reading has gone as far as all rows since the
last one would have.
"""

from __future__ import annotations

import numpy as np

from .noise import noise_estimate

#: Fewest readings.
LEAST = 20
#: From reading to reading it goes by more than so many of its sensor's steps, and of its noise's
#: deviations.
STEPS, DEVIATIONS = 4.0, 6.0
#: Rates (a row) of three steps that follow one another are alike within this factor.
ALIKE = 2.0
#: Of more than this part of the readings that move the sensor was read less often than rows were
#: written.
SELDOM = 0.5


def repeated(values: np.ndarray) -> tuple[np.ndarray, float]:
    """Which rows repeat the one before although it moves on (rows,).

    And the part of the readings on the way that such rows follow.
    """
    found = np.zeros(values.size, bool)
    starts = np.flatnonzero(np.diff(values, prepend=np.nan) != 0.0)
    if starts.size < LEAST or not np.isfinite(values).all():
        return found, 0.0
    lasts = np.diff(np.append(starts, values.size))
    steps, readings = np.diff(values[starts]), values[starts]
    least = max(STEPS * float(np.abs(steps).min()), DEVIATIONS * noise_estimate(readings))
    rates = steps / lasts[:-1]
    before, here, after = rates[:-2], rates[1:-1], rates[2:]
    smooth = np.abs(steps[1:-1]) > least
    for beside in (before, after):
        smooth &= (here * beside > 0.0) & (np.abs(here) < ALIKE * np.abs(beside))
        smooth &= np.abs(beside) < ALIKE * np.abs(here)
    goes = np.flatnonzero(smooth) + 1  # readings from which it goes on evenly
    part = float(np.mean(lasts[goes] > 1)) if goes.size >= LEAST else 0.0
    # Of a single row that is the same noise may be the reason, if it goes no farther in one.
    sure = goes if part > SELDOM else goes[np.abs(rates[goes]) > least]
    for k in sure[lasts[sure] > 1]:
        found[starts[k] + 1 : starts[k] + lasts[k]] = True
    return found, part
