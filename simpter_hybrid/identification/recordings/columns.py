"""Columns of a recording's file, as read."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class Columns:
    """Columns of a table: `numbers` as floats (rows,), `texts` as strings (rows,).

    `blank` says of columns with blank cells which these are (rows,); there `numbers` are NaN.
    `lines` are those of a text in which the rows stand (rows,), from 1; empty of arrays.
    """

    numbers: Mapping[str, np.ndarray]
    texts: Mapping[str, np.ndarray]
    size: int
    blank: Mapping[str, np.ndarray] = field(default_factory=dict)
    lines: np.ndarray = field(default_factory=lambda: np.empty(0, int))

    def values(self, name: str) -> np.ndarray:
        """A column, whatever it holds."""
        return self.numbers[name] if name in self.numbers else self.texts[name]
