"""What comes nearest to a lack that no effect explains."""

from __future__ import annotations

import numpy as np

from ..result import Diagnosis


def nearest_text(found: Diagnosis) -> str:
    """Words on what is believed to help, together, and leaves too much to be named; else ""."""
    rounds = found.search.rounds
    if not rounds or rounds[0].best is None:
        return ""
    tried = [(k, r.best) for k, r in enumerate(rounds) if k == 0 or r.verdict.accepted is not None]
    best = {k: trial for k, trial in tried if trial is not None}
    names = [t.candidate.name for t in best.values()]
    taken = 1.0 - float(np.prod([1.0 - t.gain for t in best.values()]))
    come, take = ("comes", "takes") if len(names) == 1 else ("come", "take")
    worse = (
        f", but {'' if len(names) == 1 else f'{gain.name} '}makes that of the runs held out "
        f"{-100 * gain.gain:.0f} % larger"
        for k, trial in best.items()
        for gain in (found.gains[k] if found.gains else ())
        if gain.name == trial.candidate.name and gain.surely_worse
    )
    return (
        f" ({' and '.join(names)}, which {come} nearest, {take} {100 * taken:.0f} % of the error "
        f"of the runs that select away{''.join(worse)})"
    )
