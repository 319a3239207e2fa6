"""Runs that are alike put together, whatever order a file has them in."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

T = TypeVar("T")


def put_together(
    runs: Sequence[T], alike: Callable[[T, T], bool], place: Callable[[T], Any]
) -> list[list[T]]:
    """Groups in which every two are alike; one that is like no other is alone.

    Where `alike` is a matter of closeness a run may be like two that are not like one another.
    It then belongs to one of them, and to which must not depend on which comes first in a file:
    they are gone through by their places.

    Parameters
    ----------
    runs : sequence
    alike : callable (one, other) -> bool
        Symmetric.
    place : callable (run) -> sortable
        By what they measured; those of one place are exchangeable.

    Returns
    -------
    list of list
        Groups by their first runs, and runs within each, in the order of `runs`.
    """
    groups: list[list[int]] = []
    places = [place(run) for run in runs]
    for k in sorted(range(len(runs)), key=places.__getitem__):
        fitting = (g for g in groups if all(alike(runs[j], runs[k]) for j in g))
        if (group := next(fitting, None)) is not None:
            group.append(k)
        else:
            groups.append([k])
    return [[runs[k] for k in group] for group in sorted(map(sorted, groups))]
