"""Other forms of the effects found that do as well: which of them is a matter of words."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from .fitting.fitted_model import Split, Trial
from .tracing.revision import FORMS, with_rival
from .tracing.rivals import RIVAL, nested, other_forms
from .tracing.round import Round
from .tracing.rounds import SearchResult


def forms_beside(done: SearchResult, split: Split) -> dict[str, tuple[Trial, ...]]:
    """For each effect of the corrected model, trials of other forms that end as near.

    Where it was not tried alone on the declared model, each of its forms is fitted beside all other
    effects: while one of these is missing, forms bend to what it would do, and any may come near.
    """
    found = {}
    for one in done.rounds:
        named = one.verdict.accepted
        if named is None or named.candidate not in done.corrected.effects:
            continue
        if len(done.corrected.effects) == 1 and not (one.base and one.base.effects):
            near = other_forms(named.candidate.name, one.trials, one.verdict.rivals)
        else:
            whole = replace(named, select_error=done.corrected.select_error)
            near = other_forms(named.candidate.name, [whole, *_beside(named, one, done, split)])
        found[named.candidate.name] = near
    return found


def _beside(named: Trial, one: Round, done: SearchResult, split: Split) -> Iterator[Trial]:
    """Forms of a named trial, each fitted in its place in the corrected model."""
    model = done.corrected
    alike = [
        t for t in one.trials
        if t.candidate.family == named.candidate.family
        and not nested(t, named) and t.share >= RIVAL * named.share
    ]  # fmt: skip
    for form in sorted(alike, key=lambda t: t.select_error)[:FORMS]:
        other = with_rival(form, named.candidate, model, done.refitted, split)
        if other is not None:
            # One that does better, by less than would put it in its place, comes as near.
            error = max(other.select_error, model.select_error)
            fit = replace(form.fit, values=dict(other.values))
            yield replace(form, fit=fit, select_error=error)
