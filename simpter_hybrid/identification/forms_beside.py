"""Other forms of the effects found that do as well: which of them is a matter of words."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from .fitting.fitted_model import Split, Trial
from .tracing.revision import FORMS, with_rival
from .tracing.rivals import RIVAL, nested, other_forms
from .tracing.round import Round
from .tracing.rounds import SearchResult


def forms_beside(
    done: SearchResult, split: Split, in_full: bool = True
) -> dict[str, tuple[Trial, ...]]:
    """For each effect of the corrected model, trials of other forms that end as near.

    Where it was not tried alone on the declared model, each of its forms is fitted beside all other
    effects: while one of these is missing, forms bend to what it would do, and any may come near.
    Not `in_full`: then none of such an effect is asked.
    """
    found = {}
    for one in done.rounds:
        named = one.verdict.accepted
        if named is None or named.candidate not in done.corrected.effects:
            continue
        name, tried, rivals = named.candidate.name, one.trials, one.verdict.rivals
        if len(done.corrected.effects) > 1 or (one.base is not None and one.base.effects):
            whole = replace(named, select_error=done.corrected.select_error)
            tried = (whole, *(_beside(named, one, done, split) if in_full else ()))
            rivals = ()
        near = {t.candidate.name for t in other_forms(name, tried, rivals)}
        found[name] = tuple(t for t in one.trials if t.candidate.name in near)
    return found


def _beside(named: Trial, one: Round, done: SearchResult, split: Split) -> Iterator[Trial]:
    """Forms of a named trial, with the errors that they leave in its place in the whole model."""
    model = done.corrected
    alike = [
        t for t in one.trials
        if t.candidate.family == named.candidate.family
        and not nested(t, named) and t.share >= RIVAL * named.share
    ]  # fmt: skip
    for form in sorted(alike, key=lambda t: t.select_error)[:FORMS]:
        other = with_rival(form, named.candidate, model, done.refitted, split)
        if other is not None:  # one that does better comes as near
            yield replace(form, select_error=max(other.select_error, model.select_error))
