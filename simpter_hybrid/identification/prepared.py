"""A recording with its rig, and the effects to be tried on it: what a search begins from."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from ..effect import Effect
from ..problems import InvalidInput, Problem, together
from ..reading.reader import one_of
from ..scenario import Scenario
from .benches import bench_of
from .fits import check_fits
from .recordings.copies import refuse_copies
from .recordings.groups import groups_of, groups_without_runs, holding_out, used_for
from .recordings.recording import Recording
from .rigs.bench import Bench
from .rigs.effect_candidate import EffectCandidate
from .rigs.own_effect import own_candidates

Say = Callable[[str], None]
#: Remarks that are said; the report has all.
SAID = 3


def benched(
    recording: Recording, declared: Scenario, say: Say, remark: Say
) -> tuple[Recording, Bench, dict[str, tuple[str, ...]]]:
    """The recording as it is searched, what is run of it, and what for; remarks are said."""
    groups, *_ = together(
        lambda: groups_of(recording),
        lambda: check_fits(recording, declared),
        lambda: refuse_copies(recording),
    )
    recording, used = holding_out(recording, groups), used_for(groups)
    say("; ".join(f"{part}: {', '.join(names)}" for part, names in used.items()))
    bench = bench_of(recording, declared, groups)
    bench = replace(bench, remarks=(*groups_without_runs(recording), *bench.remarks))
    for one in bench.remarks[:SAID]:
        remark(f"{one.run}: {one.what} ({one.value})")
    if len(bench.remarks) > SAID:
        remark(f"{len(bench.remarks) - SAID} more remarks stand in the report")
    return recording, bench, used


def tried_on(
    bench: Bench,
    candidates: Sequence[EffectCandidate] | None,
    without: Sequence[str],
    also: Sequence[type[Effect]],
    say: Say,
) -> tuple[tuple[EffectCandidate, ...], tuple[EffectCandidate, ...]]:
    """What is tried, and what of that is the user's own."""
    every = bench.candidates if candidates is None else tuple(candidates)
    tried = left_in(every, without)
    if gone := [c.name for c in every if c not in tried]:
        say(f"left out, with all of the same kind: {', '.join(gone)}")
    own = own_candidates(also, tried, bench.predictor)
    tried = (*tried, *own)
    if barred := [c.name for c in tried if not bench.predictor.combines(c)]:
        say(f"not tried, since they do not go with what is declared: {', '.join(barred)}")
        tried = tuple(c for c in tried if c.name not in barred)
    return tried, own


def left_in(
    candidates: tuple[EffectCandidate, ...], without: Sequence[str]
) -> tuple[EffectCandidate, ...]:
    """Candidates of other families than those of the effects named.

    Raises
    ------
    InvalidInput
        If a name is no effect of this rig.
    """
    known = {c.name: c.family for c in candidates}
    problems = [
        Problem("--without", "", "no such effect of this rig", name, one_of(known, name))
        for name in without
        if name not in known
    ]
    if problems:
        raise InvalidInput(problems)
    return tuple(c for c in candidates if c.family not in {known[name] for name in without})
