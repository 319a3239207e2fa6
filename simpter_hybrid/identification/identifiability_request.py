"""What the runs of a diagnosis see and confuse, and what is asked of a next one."""

from __future__ import annotations

from .fitting.fitted_model import Trial
from .identifiability_report import Sight, sight
from .result import Diagnosis


def seen_by(found: Diagnosis) -> Sight:
    """What the selecting runs see, what they confuse, which experiment would tell more."""
    done = found.search
    runs = found.split.select
    asked = [*(r.verdict for r in done.rounds), done.verdict]
    asked = asked if done.verdict.accepted is not None else []
    # Where nothing is repeated, deviations are what the declared model leaves, not the noise: what
    # a model leaves that is far from it hides an effect as noise does.
    unit = min(1.0, max(done.floor, done.corrected.select_error))
    plan = found.experiments
    planned = plan(done.refitted.values, runs) if plan is not None else ()
    forms = forms_asked(found)
    return sight(done.refitted, found.candidates, runs, planned, asked, unit, forms)


def forms_asked(found: Diagnosis) -> list[tuple[Trial, Trial]]:
    """Pairs of a named effect and a form that does as well, one of them a declared value."""
    return [
        (named, form)
        for r in found.search.rounds
        if (named := r.verdict.accepted) is not None
        for form in found.forms.get(named.candidate.name, ())
        if form.candidate.declared != named.candidate.declared
    ]
