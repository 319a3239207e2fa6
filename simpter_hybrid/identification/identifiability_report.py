"""Before any search: what these experiments can see, what they confuse, which of them separates."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .fit import Fitter
from .identifiability import beyond, blind_to, confused, separation, visibility
from .predictor import Candidate
from .replay import Replay
from .residual import residual_parts
from .search import Model

#: A candidate at its typical size: this many of its parameters' typical changes from no effect.
SIZE = 3.0


@dataclass(frozen=True)
class Sight:
    """What the experiments see.

    Parameters
    ----------
    visible : mapping of str to float
        Relative rise of the error that each effect would cause at its typical size.
    blind, confused : tuples
        Effects that would go unseen; pairs that could not be told apart, with the part imitated.
    run_next : mapping of pair to tuple of (experiment, distance)
        For each confused pair the experiments that hold the two farthest apart [noise deviations].
    """

    visible: Mapping[str, float]
    blind: tuple[str, ...]
    confused: tuple[tuple[str, str, float], ...]
    run_next: Mapping[tuple[str, str], tuple[tuple[str, float], ...]]


def sight(base: Model, candidates: Sequence[Candidate], replays: Sequence[Replay]) -> Sight:
    """Simulate every candidate at its typical size on `replays`.

    Declared parameters may imitate an effect only as far as their tolerances let them: their
    columns are those of `base`'s own fit on the same replays.
    """
    predictor, values = base.predictor, base.values
    fitter = Fitter(predictor, replays)
    at = fitter.residuals(values)
    columns = fitter.jacobian(values, at)
    parts = residual_parts(predictor.predict(values, replays), replays)
    sizes = [p.size for _, _, p in parts]
    owner = np.repeat([i for _, i, _ in parts], sizes)
    without = np.concatenate([p for _, _, p in parts])
    columns = columns[: without.size]
    signals = {}
    for candidate in candidates:
        extended = predictor.extended(candidate)
        own = {
            p.name: p.value if np.isfinite(p.tolerance) else typical_value(p, s)
            for p, s in zip(candidate.parameters, candidate.starts[0], strict=True)
        }
        changed = residual_parts(extended.predict({**values, **own}, replays), replays)
        change = np.concatenate([p for _, _, p in changed]) - without
        signals[candidate.name] = beyond(change, columns)
    pairs = confused(signals)
    names = [r.name for r in replays]
    following = {
        (a, b): tuple(separation(signals[a], signals[b], owner, names).items())[:3]
        for a, b, _ in pairs
    }
    seen = {name: visibility(change) for name, change in signals.items()}
    return Sight(seen, blind_to(signals), pairs, following)


def typical_value(parameter, start: float) -> float:
    """A value at which the effect is as large as is typical."""
    if abs(start) > 1e-12:
        return start
    value = parameter.value + SIZE * parameter.typical
    return min(max(value, parameter.lower), parameter.upper)
