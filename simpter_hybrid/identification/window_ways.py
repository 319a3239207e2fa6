"""How far a record and a model go in the windows of a channel of which straight lines are taken."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from .fitting.replay import Observation

#: A record goes far by so many deviations of the means of a window's first and last quarter.
FAR = 8.0
#: A model rests in a window where it moves by less than this part of the record's way.
RESTS = 0.25


class Way(NamedTuple):
    """Ways of the record and the model between a window's first and last quarter, with signs.

    `far`: the record's is more than noise; `reach`: from the least to the largest of the model.
    """

    gone: float
    went: float
    reach: float
    far: bool

    @property
    def rests(self) -> bool:
        """Whether the model rests where the record goes far."""
        return self.far and self.reach < RESTS * abs(self.gone)


def window_ways(seen: Observation, predicted: np.ndarray) -> Iterator[Way]:
    """The ways in every window, none where no line is taken; of too few rows one that is none.

    Parameters
    ----------
    seen : Observation
    predicted : ndarray (samples,)
        By the model [SI].
    """
    if not seen.lines or not seen.windows:
        return
    for a, b in zip(seen.windows, (*seen.windows[1:], seen.values.size), strict=True):
        kept = seen.keep[a:b]
        values, model = seen.values[a:b][kept], predicted[a:b][kept]
        rows = max(1, values.size // 4)
        if values.size < 2 * rows:
            yield Way(0.0, 0.0, 0.0, False)
            continue
        gone, went = (float(np.mean(v[-rows:]) - np.mean(v[:rows])) for v in (values, model))
        far = abs(gone) > FAR * seen.own * seen.sd * np.sqrt(2.0 / rows)
        yield Way(gone, went, float(np.ptp(model)), bool(far))
