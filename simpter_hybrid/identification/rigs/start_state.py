"""State at the start of a free prediction, from positions alone."""

from __future__ import annotations

import numpy as np

#: A sample is read before a restart at its own instant: to begin a window it must come after one
#: that is so much earlier [s].  In it nothing moves by more than a billionth of a second's way.
JUST_BEFORE = 1e-9
#: A speed below this many of its standard deviations is rest.
RESTS = 4.0


#: A first state is fitted to rows for as long as a polynomial leaves no more than noise, within so
#: many standard errors of that and up to so long [s]; so much more rows are tried at a time.
ERRORS, LONGEST, GROWS = 3.0, 0.5, 1.3


def first_state(
    time: np.ndarray, values: np.ndarray, fewest: int, sd: float, degree: int
) -> tuple[float, float]:
    """Position and speed at the first sample, by as many samples as one polynomial serves.

    A whole run goes by its start: over nine rows of a film a push of 0.1 m/s was none.
    """
    t = time - time[0]
    best = count = min(fewest, t.size)
    while (count := max(count + 1, round(GROWS * count))) <= t.size and t[count - 1] <= LONGEST:
        fit = np.polynomial.Polynomial.fit(t[:count], values[:count], degree)
        free = count - degree - 1
        left = float(np.sqrt(np.sum((values[:count] - fit(t[:count])) ** 2) / free))
        if left > (1.0 + ERRORS / np.sqrt(2.0 * free)) * sd:
            break
        best = count
    return _at_zero(t[:best], values[:best], sd, degree)


def start_state(
    values: np.ndarray, k: int, half: int, step: float, sd: float, degree: int = 2
) -> tuple[float, float]:
    """Position and speed at sample `k` of the polynomial through the samples around it."""
    first = max(0, k - half)
    span = values[first : k + half + 1]
    return _at_zero((np.arange(span.size) - (k - first)) * step, span, sd, degree)


def _at_zero(t: np.ndarray, values: np.ndarray, sd: float, degree: int) -> tuple[float, float]:
    powers = np.vander(t, degree + 1, increasing=True)
    fit = np.linalg.lstsq(powers, values, rcond=None)[0]
    speed_sd = sd * float(np.sqrt(np.linalg.inv(powers.T @ powers)[1, 1]))
    return float(fit[0]), float(fit[1]) if abs(fit[1]) > RESTS * speed_sd else 0.0
