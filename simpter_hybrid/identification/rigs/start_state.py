"""State at the start of a free prediction, from positions alone."""

from __future__ import annotations

import numpy as np

#: A sample is read before a restart at its own instant: to begin a window it must come after one
#: that is so much earlier [s].  In it nothing moves by more than a billionth of a second's way.
JUST_BEFORE = 1e-9
#: A speed below this many of its standard deviations is rest.
RESTS = 4.0


def start_state(
    values: np.ndarray, k: int, half: int, step: float, sd: float, degree: int = 2
) -> tuple[float, float]:
    """Position and speed at sample `k` of the polynomial through the samples around it."""
    first = max(0, k - half)
    span = values[first : k + half + 1]
    t = (np.arange(span.size) - (k - first)) * step
    powers = np.vander(t, degree + 1, increasing=True)
    fit = np.linalg.lstsq(powers, span, rcond=None)[0]
    speed_sd = sd * float(np.sqrt(np.linalg.inv(powers.T @ powers)[1, 1]))
    return float(fit[0]), float(fit[1]) if abs(fit[1]) > RESTS * speed_sd else 0.0
