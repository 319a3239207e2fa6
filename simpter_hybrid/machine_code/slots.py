"""Records handed to machine code."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

INTEGER = np.int64


class Slots:
    """A record of the compiled kernel: 8-byte slots, set by name; ``kinds`` of them by name."""

    def __init__(self, kinds: Mapping[str, str], **values: Any) -> None:
        self.kinds = kinds
        self.places = dict(zip(kinds, range(len(kinds)), strict=True))
        self.integers = np.zeros(len(kinds), dtype=INTEGER)
        self.floats = self.integers.view(float)
        self.alive: list[np.ndarray] = []
        for name, value in values.items():
            self.set(name, value)

    def set(self, name: str, value: Any) -> None:
        """Set a field to a number or to an array."""
        kind, at = self.kinds[name], self.places[name]
        if kind == "f":
            self.floats[at] = value
        elif kind in "iv":
            self.integers[at] = value
        else:
            array = np.ascontiguousarray(value, dtype=float if kind == "A" else INTEGER)
            self.alive.append(array)
            # No address is asked for where there is nothing: it costs more than the rest.
            self.integers[at] = array.ctypes.data if array.size else 0

    @property
    def address(self) -> int:
        return self.integers.ctypes.data
