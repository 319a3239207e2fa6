"""Whether an effect of one's own can be simulated before thousands of runs ask it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...problems import InvalidInput, Problem
from ..fitting.replay import Replay
from .effect_candidate import EffectCandidate
from .free_start import Predicted
from .scenario_predictor import ScenarioPredictor

#: An effect whose sizes are 0 changes a prediction by no more than this part: steps differ.
NEUTRAL = 1e-4


def check_own(
    candidates: Sequence[EffectCandidate],
    predictor: ScenarioPredictor,
    values: Mapping[str, float],
    replays: Sequence[Replay],
) -> None:
    """Check that own effects can be simulated, and do nothing where their sizes are 0.

    Parameters
    ----------
    candidates : sequence of EffectCandidate
        By `own_candidates`.
    predictor, values
        The declared model.
    replays : sequence of Replay
        Runs over which they are tried.

    Raises
    ------
    InvalidInput
        With one problem for each candidate that fails or acts at size 0.
    """
    problems, without = [], predictor.predict(values, replays)
    for made in candidates:
        where, extended = f"--also {type(made.effect).__name__}", predictor.extended(made)
        neutral = {**values, **{p.name: p.value for p in made.parameters}}
        starts = [dict(zip((p.name for p in made.parameters), s, strict=True)) for s in made.starts]
        for begun in (neutral, *({**values, **start} for start in starts)):
            if not _finite(extended.predict(begun, replays), without):
                own = {p.name: begun[p.name] for p in made.parameters}
                said = ", ".join(f"{name} {value:g}" for name, value in own.items())
                right = "a law that is a finite number whatever the motion"
                problems.append(Problem(where, "", "cannot be simulated", said, right))
                break
        else:
            off = _apart(extended.predict(neutral, replays), without)
            if made.sizes and all(neutral[size] == 0.0 for size in made.sizes) and off > NEUTRAL:
                right = "a law that changes nothing where its sizes are 0, or no sizes"
                value = f"a change of {off:.2g} of the prediction"
                problems.append(Problem(where, "sizes", "it acts where they are 0", value, right))
    if problems:
        raise InvalidInput(problems)


def _finite(predicted: Predicted, without: Predicted) -> bool:
    """Whether a prediction has numbers wherever the model without the effect has them."""
    pairs = (
        (a, b) for name in without for a, b in zip(predicted[name], without[name], strict=True)
    )
    return all(np.isfinite(a[np.isfinite(b)]).all() for a, b in pairs)


def _apart(predicted: Predicted, without: Predicted) -> float:
    """Largest difference of two predicted motions, relative to their range."""
    found = [0.0]
    for name in (n for n in without if n.startswith(("position", "speed"))):
        for a, b in zip(predicted[name], without[name], strict=True):
            reach = float(np.nanmax(np.abs(b), initial=0.0))
            found.append(float(np.nanmax(np.abs(a - b), initial=0.0)) / reach if reach else 0.0)
    return max(found)
