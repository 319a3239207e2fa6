"""An elastic part of a driven axis, and at which frequencies fits of it begin."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...effects.flexible_mode import FlexibleMode
from ..fitting.replay import Replay
from ..rigs.candidate import candidate
from ..rigs.effect_candidate import EffectCandidate
from ..tracing.swings import STANDS_OUT, strongest
from .candidates import of_axis, of_one_balance

#: Rows in a swing that a record has to have to show it; the slowest that is looked for [Hz].
ROWS, SLOWEST = 4.0, 0.3
#: Where fits begin, in parts of the highest frequency: from one three times off they still end at
#: the right one.
FROM = (0.04, 0.12, 0.4)
#: ... with this part of the inertia, and this damping: a broad resonance is found from farther off.
HUNG, DAMPED = 0.1, 0.03


def flexible_candidates(
    replays: Sequence[Replay], inertia: float, turning: bool
) -> tuple[EffectCandidate, ...]:
    """A part of the `inertia` on a spring; none where rows are too far apart to show one."""
    steps = [float(np.median(np.diff(r.time))) for r in replays]
    highest = 1.0 / (ROWS * max(steps))
    if highest <= SLOWEST / FROM[0]:
        return ()
    lines = [strongest(r.notes["speed"], step) for r, step in zip(replays, steps, strict=True)]
    told = [line for line in lines if line and line.over >= STANDS_OUT and line.frequency < highest]
    seen = [max(told, key=lambda line: line.over).frequency] if told else []
    return (flexible_mode(inertia, highest, (*seen, *(part * highest for part in FROM)), turning),)


def flexible_mode(
    inertia: float, highest: float, begins: Sequence[float], turning: bool
) -> EffectCandidate:
    """The candidate, up to the `highest` frequency [Hz], begun at several."""
    made = candidate(
        "flexible-mode", FlexibleMode(coordinate=0),
        (("mass", 0.0, 0.95 * inertia, 0.02 * inertia),
         ("frequency", SLOWEST, highest, 0.1 * highest), ("damping", 0.0, 1.0, 0.02)),
        tuple((HUNG * inertia, frequency, DAMPED) for frequency in begins),
        ("acceleration", "time", "displacement_since_reversal"),
    )  # fmt: skip
    return replace(of_one_balance(made), experiment=of_axis(made.experiment, turning))
