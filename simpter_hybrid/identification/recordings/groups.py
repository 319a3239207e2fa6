"""Which groups of runs fit, which select, and which are reported on only."""

from __future__ import annotations

from collections.abc import Sequence

from ...problems import InvalidInput, Problem, Problems
from .recording import Recording

#: What a group may be for.
PARTS = ("fit", "select", "report")


def groups_of(recording: Recording) -> dict[str, tuple[str, ...]]:
    """Which groups fit, select and report: the map's split, or else half, a quarter, a quarter.

    Raises
    ------
    InvalidInput
        If there are too few runs to hold any out, no run is of what a part of the split names, or
        the map reports on runs that fit or select.
    """
    known = list(recording.grouped())
    if any(recording.map.split.values()):
        _check_split(recording, known)
        return {part: tuple(g for g in recording.map.split[part] if g in known) for part in PARTS}
    if len(known) < len(PARTS):
        right = "a [split] in the map, or at least three groups of runs"
        got = f"{len(known)}: {', '.join(known)}"
        problem = Problem(recording.source, "split", "nothing can be held out", got, right)
        raise InvalidInput([problem])
    half = max(1, len(known) // 2)
    third = max(1, (len(known) - half) // 2)
    parts = known[:half], known[half : half + third], known[half + third :]
    return dict(zip(PARTS, map(tuple, parts), strict=True))


def groups_without_runs(recording: Recording) -> list[str]:
    """Groups that the map's split names and no run is of."""
    named = {name for part in recording.map.split.values() for name in part}
    return sorted(named - set(recording.grouped()))


def _check_split(recording: Recording, known: Sequence[str]) -> None:
    """A wrong name must not turn runs that were to be held out into runs that are fitted."""
    split, problems = recording.map.split, Problems(recording.map.source)
    there = f"there are {', '.join(known[:8])}{' ...' if len(known) > 8 else ''}"
    for part in PARTS:
        names = split.get(part, ())
        if not set(names) & set(known):
            got = ", ".join(names) or "none"
            problems.add(
                ("split", part), "names no group that has runs", got, f"groups of runs; {there}"
            )
    used = {*split.get("fit", ()), *split.get("select", ())}
    for name in split.get("report", ()):
        if name in used:
            right = f"groups that neither fit nor select; {there}"
            problems.add(("split", "report"), "a group that is not held out", name, right)
    problems.raise_if_any()
