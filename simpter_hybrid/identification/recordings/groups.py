"""Which groups of runs fit, which select, and which are reported on only."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from ...problems import InvalidInput, Problem, Problems
from .at_gaps import as_boundaries
from .checks import FEWEST, Finding
from .recording import Recording
from .runs import ONLY, name_of_whole
from .shortest import (
    lasts,
    longest_run,
    most_pieces,
    of_one_axis,
    shortest,
    shortest_halved,
)

#: What a group may be for.
PARTS = ("fit", "select", "report")
#: What a group of each has to be, where none is named.
OF_PART = {
    "fit": ", to which parameters are fitted",
    "select": " that does not fit, or the same as fit, for halves of each run",
    "report": " that neither fits nor selects",
}
#: Into how many a single long run is cut, if it is long enough.
PIECES = 4


def groups_of(recording: Recording) -> dict[str, tuple[str, ...]]:
    """Which groups fit, select and report: the map's split, or else half, a quarter, a quarter.

    In the order of the file; of runs in pieces the first ones of all come first, for each run may
    be of another kind, and what no fitted run shows has no size.

    Raises
    ------
    InvalidInput
        If there are too few runs to hold any out, no run is of what a part of the split names, the
        map reports on runs that fit or select, or only some groups both fit and select.
    """
    grouped = recording.grouped()
    known = sorted(grouped, key=lambda group: grouped[group][0].piece)
    if any(recording.map.split.values()):
        _check_split(recording, known)
        return {part: tuple(g for g in recording.map.split[part] if g in known) for part in PARTS}
    if len(known) < len(PARTS):
        right = f"at least three groups of runs{_by_gaps(recording)}{_by_pieces(recording, known)}"
        got = f"{len(known)}: {'; '.join(known)}"
        problem = Problem(recording.source, "split", "nothing can be held out", got, right)
        raise InvalidInput([problem])
    half = max(1, len(known) // 2)
    third = max(1, (len(known) - half) // 2)
    parts = known[:half], known[half : half + third], known[half + third :]
    return dict(zip(PARTS, map(tuple, parts), strict=True))


def _by_gaps(recording: Recording) -> str:
    """Advice how a column that nothing uses would part runs where rows are missing, if one does."""
    if not recording.at_gaps:
        return ""
    where = "that column changes where rows are missing, and only there"
    return f", as {as_boundaries(recording.at_gaps)} parts them ({where})"


def _by_pieces(recording: Recording, known: Sequence[str]) -> str:
    """Advice how cutting runs (`pieces`) would make three groups, or how two would do."""
    told = recording.map.pieces
    rows = min(run.time.size for run in recording.runs) * told
    timed = of_one_axis(recording)  # of other rigs nothing is asked of how long a run lasts
    pieces = min(PIECES, rows // FEWEST, most_pieces(recording) if timed else PIECES)
    if len(known) * pieces < len(PARTS) * told:
        long, least, three = lasts(longest_run(recording)), shortest(recording), len(PARTS)
        lasting = (f"{least:g} s", f"{three * least:.2g} s") if timed else ("", "")
        each, for_three = (f" and {time}" if time else "" for time in lasting)
        there = f" in {long * told:.3g} s" if timed else ""
        short = (
            f"; these are too short to be cut so: {FEWEST} rows{each} each are asked for "
            f"({three * FEWEST} rows{for_three} for three), and there are {rows} rows{there}"
        )
        first, last, cut = known[0], known[-1], ""
        if len(known) == 1 and pieces >= 2:
            # As the pieces will be called: by their group, if runs have one.
            alone = recording.runs[0].name == ONLY and not recording.map.run_columns
            of = "" if alone else f"{first}, "
            first, last = f"{of}piece 1", f"{of}piece 2"
            cut = f"; pieces = {pieces} under its [runs]"
            long *= told / pieces
        if first == last or (timed and long < shortest_halved(recording)):
            return short
        both = f'fit = ["{first}"], select = ["{first}"], report = ["{last}"]'
        return (
            f"{short}{cut}, and a [split] in the map where one group both fits and selects: {both}"
        )
    return (
        f", or a [split] in the map; pieces = {pieces} under its [runs] cuts each run into so many"
    )


def groups_without_runs(recording: Recording) -> tuple[Finding, ...]:
    """A remark where the map's split names groups that no run is of."""
    named = {name for part in recording.map.split.values() for name in part}
    known = set(recording.grouped())
    if not named - known:
        return ()
    what = "the map's [split] names groups that no run is of"
    rest = "; ".join(sorted(known - named))
    right = "groups of this recording" + (f"; used for nothing are {rest}" if rest else "")
    return (Finding.of_all(what, "; ".join(sorted(named - known)), right),)


def shared(groups: Mapping[str, Sequence[str]]) -> bool:
    """Whether the same runs fit and select: each gives its halves then."""
    return bool(set(groups["fit"]) & set(groups["select"]))


def several(recording: Recording) -> bool:
    """Whether it holds more than one whole run: between pieces of one nothing is made anew.

    Parameters
    ----------
    recording : Recording
    """
    return len({name_of_whole(run) for run in recording.runs}) > 1


def without_held_out(recording: Recording, groups: Mapping[str, Sequence[str]]) -> Recording:
    """The recording as the search may see it: runs that fit or select."""
    used = {*groups["fit"], *groups["select"]}
    return replace(recording, runs=tuple(r for r in recording.runs if r.group in used))


def holding_out(recording: Recording, groups: Mapping[str, Sequence[str]]) -> Recording:
    """The recording with the groups named that neither fit nor select."""
    used = {*groups["fit"], *groups["select"]}
    return replace(recording, held_out=tuple(g for g in groups["report"] if g not in used))


def refuse_halves(recording: Recording, groups: Mapping[str, Sequence[str]], rig: str) -> None:
    """Check that no group fits and selects at once, for a rig whose runs are not halved.

    Raises
    ------
    InvalidInput
        If a group is in both.
    """
    if shared(groups):
        what = f"groups that fit as well, and runs of {rig} are not halved"
        got, right = "; ".join(groups["select"]), "other groups than those that fit"
        raise InvalidInput([Problem(recording.map.source, "split.select", what, got, right)])


def used_for(groups: Mapping[str, Sequence[str]]) -> dict[str, tuple[str, ...]]:
    """What each part is, for a reader: groups, or halves of their runs."""
    told = {part: tuple(names) for part, names in groups.items()}
    if shared(groups):
        told["fit"] = tuple(f"{name} (first half of each run)" for name in groups["fit"])
        told["select"] = tuple(f"{name} (second half of each run)" for name in groups["select"])
    return told


def _check_split(recording: Recording, known: Sequence[str]) -> None:
    """A wrong name must not turn runs that were to be held out into runs that are fitted."""
    split, problems = recording.map.split, Problems(recording.map.source)
    there = f"there are {'; '.join(known[:8])}{' ...' if len(known) > 8 else ''}"
    for part in PARTS:
        names = split.get(part, ())
        if not set(names) & set(known):
            what, got = "names no group that has runs", "; ".join(names)
            right = f"groups of runs; {there}"
            if not names:
                what, got = "missing or empty", "[]"
                right = f"at least one group of runs{OF_PART[part]}; {there}"
            problems.add(("split", part), what, got, right)
    used = {*split.get("fit", ()), *split.get("select", ())}
    for name in split.get("report", ()):
        if name in used:
            right = f"groups that neither fit nor select; {there}"
            problems.add(("split", "report"), "a group that is not held out", name, right)
    fits, selects = (
        set(split.get("fit", ())) & set(known),
        set(split.get("select", ())) & set(known),
    )
    if fits & selects and fits != selects:
        # To select by what was fitted tells nothing, and halves of all would be another split.
        what = "groups that fit as well, though not all of them do both"
        right = "other groups than those that fit; or the same, for halves of each run"
        problems.add(("split", "select"), what, "; ".join(sorted(fits & selects)), right)
    problems.raise_if_any()
