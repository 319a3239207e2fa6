"""Of forms that contain the same simpler one, those worth a fit: what they do beyond its end.

Each does at least what the simpler one does, so what they promise from a start tells three waves a
turn from twelve no more.  Their further numbers, moved where the simpler one has ended, do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from .effort import effort_of
from .fit import Fitter
from .fitted_model import Model, Split, Trial, with_effect
from .memory import Memory
from .predictor import Candidate
from .survey import PROMISE, WORTH, linear_step

#: So few forms of one simpler one are all fitted.
FEW = 3


def beyond_simpler(
    forms: Sequence[Candidate],
    ended: Mapping[str, Trial],
    base: Model,
    split: Split,
    memory: Memory,
) -> list[Candidate]:
    """Forms, begun where the simpler one of each has ended, that promise something beyond it.

    Of few all; of many that differ in one number (waves a turn) those whose further numbers take
    away, in one linear step, enough of what the simpler one leaves, and of what the best does, be
    that one of those that were fitted before.
    """
    if effort_of(base.predictor).used_up:  # nor is any of them fitted then
        return []
    kept: list[Candidate] = []
    for name in dict.fromkeys(form.simpler for form in forms):
        alike = [form for form in forms if form.simpler == name]
        if len(alike) <= FEW:
            kept += alike
            continue
        end = with_effect(base, ended[name], split)
        known = [t.fit.cost for t in ended.values() if t.candidate.simpler == name]
        gains = [
            memory.of(base, ("beyond", form.name, end.cost), partial(_gain, end, form, base, split))
            for form in alike
        ]
        least = max(PROMISE, WORTH * max(*gains, *(1.0 - cost / end.cost for cost in known)))
        kept += [form for form, gain in zip(alike, gains, strict=True) if gain >= least]
    return kept


def _gain(end: Model, form: Candidate, base: Model, split: Split) -> float:
    """Part of the sum of squares at a simpler form's end that further numbers take away."""
    fitter = Fitter(base.predictor.extended(form), split.fit, unit=base.unit)
    values, rows = dict(form.fitted), end.residuals.size
    seen, columns = fitter.residuals(values)[:rows], []
    for p in form.parameters:
        if values[p.name] != p.value:  # of the simpler form, whose column is known
            continue
        step = p.difference(p.value, p.typical)
        moved = fitter.residuals({**values, p.name: p.value + step})[:rows]
        columns.append((moved - seen) * (p.typical / step))
    if not columns:
        return 0.0
    return linear_step(seen, list(end.columns.values()), np.column_stack(columns))[0]
