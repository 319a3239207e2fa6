"""Which runs are nearly of one course, and not near enough to count as repeated."""

from __future__ import annotations

from collections.abc import Sequence

from ..fitting.repeats import ALIKE, ALIKE_WHOLE, repetitions
from ..fitting.replay import Replay
from .told_apart import listed


def nearly_repeated_sentence(replays: Sequence[Replay]) -> str:
    """Sentence on runs followed whole that differ by more than is allowed to them; "" if none do.

    Whoever has let a device go three times expects that the three tell its noise.

    Parameters
    ----------
    replays : sequence of Replay
        That fit and that select.
    """
    known = [{run.name for run in group} for group in repetitions(replays)]
    groups = [
        [run.name for run in group]
        for group in repetitions(replays, ALIKE)
        if any(run.followed for run in group)
    ]
    nearly = [names for names in groups if not any(one >= {*names} for one in known)]
    if not nearly:
        return ""
    return (
        f"Nearly of one course, but not all counted as repeated: {listed(nearly)}. Of runs that "
        "are followed whole (let alone, or of a servo with its own loop) every two have to agree "
        f"within {100 * ALIKE_WHOLE:g} % of their signals; some of these do within "
        f"{100 * ALIKE:g} % only: what those differ by is not taken for noise."
    )
