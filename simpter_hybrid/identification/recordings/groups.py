"""Which groups of runs fit, which select, and which are reported on only."""

from __future__ import annotations

from collections.abc import Sequence

from ...problems import InvalidInput, Problem, Problems
from .recording import Recording


def groups_of(recording: Recording) -> dict[str, tuple[str, ...]]:
    """Which groups fit, select and report: the map's split, or else half, a quarter, a quarter.

    Raises
    ------
    InvalidInput
        If there are too few runs to hold any out, or the map reports on runs that fit or select.
    """
    known = list(recording.grouped())
    _check_split(recording, known)
    named = {k: tuple(g for g in v if g in known) for k, v in recording.map.split.items()}
    if all(named.get(k) for k in ("fit", "select", "report")):
        return named
    if len(known) >= 3:
        half = max(1, len(known) // 2)
        third = max(1, (len(known) - half) // 2)
        parts = known[:half], known[half : half + third], known[half + third :]
        return dict(zip(("fit", "select", "report"), map(tuple, parts), strict=True))
    right = "a [split] in the map, or at least three groups of runs"
    if absent := groups_without_runs(recording):
        right = f"runs of {', '.join(absent)}, which the map's [split] names"
    problem = Problem(recording.source, "split", "nothing can be held out", str(len(known)), right)
    raise InvalidInput([problem])


def groups_without_runs(recording: Recording) -> list[str]:
    """Groups that the map's split names and no run is of."""
    named = {name for part in recording.map.split.values() for name in part}
    return sorted(named - set(recording.grouped()))


def _check_split(recording: Recording, known: Sequence[str]) -> None:
    split, problems = recording.map.split, Problems(recording.map.source)
    used = {*split.get("fit", ()), *split.get("select", ())}
    for name in split.get("report", ()):
        if name not in used:
            continue
        right = f"groups that neither fit nor select; there are {', '.join(known[:8])}"
        problems.add(("split", "report"), "a group that is not held out", name, right)
    problems.raise_if_any()
