"""What a search has fitted: asked again at another floor, it is not simulated again.

A floor is known for sure only when a search has ended, and moves no fit by itself.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any, TypeVar

from .effort import effort_of
from .fitted_model import Model

T = TypeVar("T")


class Memory:
    """Results of fits, kept for one declared model, one split of runs and their weights."""

    def __init__(self) -> None:
        self._known: dict[Hashable, Any] = {}

    def of(self, base: Model, asked: Hashable, made: Callable[[], T]) -> T:
        """The result of `made` for what was asked of a base, computed only the first time."""
        if (key := _key(base, asked)) not in self._known:
            self._known[key] = made()
        return self._known[key]

    def barred(self, base: Model, asked: Hashable) -> bool:
        """Whether that is not known, and the effort to compute it is used up."""
        return effort_of(base.predictor).used_up and _key(base, asked) not in self._known


def _key(base: Model, asked: Hashable) -> Hashable:
    effects = tuple(c.name for c in base.effects)
    return effects, tuple(sorted(base.values.items())), base.unit, asked
