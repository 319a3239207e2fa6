"""What linear least squares leave."""

from __future__ import annotations

import numpy as np


def beyond(change: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """`change` less its projection on the span of `columns`."""
    if columns.size == 0:
        return change
    return change - columns @ np.linalg.lstsq(columns, change, rcond=None)[0]
