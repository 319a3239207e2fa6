"""What a search has fitted: asked again at another floor, it is not simulated again.

A floor is known for sure only when a search has ended, and moves no fit by itself.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any, TypeVar

from .fitted_model import Model

T = TypeVar("T")


class Memory:
    """Results of fits, kept for one declared model, one split of runs and their weights."""

    def __init__(self) -> None:
        self._known: dict[Hashable, Any] = {}

    def of(self, base: Model, asked: Hashable, made: Callable[[], T]) -> T:
        """The result of `made` for what was asked of a base, computed only the first time."""
        effects = tuple(c.name for c in base.effects)
        key = (effects, tuple(sorted(base.values.items())), base.unit, asked)
        if key not in self._known:
            self._known[key] = made()
        return self._known[key]
