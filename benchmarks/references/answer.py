"""What a solver says about a run, and how far that is from the truth."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from simpter_hybrid.comparison.events import Change, match

#: Changes of mode further apart than this are not the same one [s].
WINDOW = 0.02


class Answer(NamedTuple):
    """``end``: final angles and speeds (4,); ``story``: (t, modes after) of every change."""

    end: np.ndarray
    story: list[tuple[float, tuple[int, ...]]]


class Distance(NamedTuple):
    """Errors of an answer.

    ``state``: largest of the final angles [rad] and speeds [rad/s]; ``event``: largest shift of a
    change [s], ``WINDOW`` where one is missed; counts of changes.
    """

    state: float
    event: float
    changes: int
    missed: int
    invented: int


def changes_of(story: list[tuple[float, tuple[int, ...]]]) -> list[Change]:
    """Stops and releases after the start."""
    found = []
    for (_, before), (t, after) in pairwise(story):
        found += [Change(t, i + 1, b) for i, b in enumerate(after) if before[i] != b]
    return found


def distance(answer: Answer, truth: Answer) -> Distance:
    """Errors of an answer."""
    right = changes_of(truth.story)
    found = match(right, changes_of(answer.story), WINDOW)
    return Distance(
        float(np.abs(answer.end - truth.end).max()),
        WINDOW if found.missed else found.largest_shift,
        len(right), len(found.missed), len(found.invented),
    )  # fmt: skip


def thinned(modes: np.ndarray, step: float) -> list[tuple[float, tuple[int, ...]]]:
    """The story of modes (steps, m) found at the ends of equal steps."""
    new = np.flatnonzero(np.any(modes[1:] != modes[:-1], axis=1)) + 1
    return [((k + 1) * step, tuple(modes[k].tolist())) for k in (0, *new)]
