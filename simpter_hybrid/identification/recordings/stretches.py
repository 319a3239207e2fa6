"""Stretches of samples for which something holds."""

from __future__ import annotations

import numpy as np


def stretches(true: np.ndarray) -> list[slice]:
    """Samples between which `true` (samples,) holds all through, in order."""
    edges = np.flatnonzero(np.diff(true.astype(int), prepend=0, append=0)).reshape(-1, 2)
    return [slice(begin, end) for begin, end in edges.tolist()]
