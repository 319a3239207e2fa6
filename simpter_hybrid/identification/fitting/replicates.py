"""Runs with the same inputs: which they are, and their means.

Whether a channel that was logged beside had values in common is a matter of closeness, so of three
runs one may go with either of the others.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from .alike import put_together
from .replay import Observation, Replay


def same_inputs(a: Replay, b: Replay) -> bool:
    """Whether one replay serves two runs: same stamps, inputs, constants and measured channels.

    Names of experiments do not matter.  Channels logged beside may have an effect, so they must
    have values in common: a run that was warmer all through is another one.
    """
    return (
        a.drive_is_exact
        and b.drive_is_exact
        and a.setting == b.setting
        and a.time.size == b.time.size
        and np.allclose(a.time, b.time, rtol=0, atol=1e-9)
        and a.inputs.keys() == b.inputs.keys()
        and all(np.array_equal(a.inputs[k], b.inputs[k]) for k in a.inputs)
        and a.observed.keys() == b.observed.keys()
        and all(_overlap(a.logged[k], b.logged[k]) for k in a.logged.keys() & b.logged.keys())
    )


def _overlap(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two courses have values in common; one without numbers counts as having."""
    known = [x[np.isfinite(x)] for x in (one, other)]
    if not all(x.size for x in known):
        return True
    return bool(max(x.min() for x in known) <= min(x.max() for x in known))


def merged(replays: Sequence[Replay]) -> list[Replay]:
    """Replicates without restarts replaced by their mean: as much information, half the cost."""
    return merged_as(replays, replays)


def merged_as(replays: Sequence[Replay], changed: Sequence[Replay]) -> list[Replay]:
    """Changed replays, one for each of `replays`, merged as these are.

    What a change makes of a run's beginning may decide whether it restarts: by itself it would be
    merged with others.
    """
    new = {id(old): one for old, one in zip(replays, changed, strict=True)}
    groups = put_together(replays, _averaged, _place)
    return [_mean([new[id(run)] for run in group]) for group in groups]


def _averaged(a: Replay, b: Replay) -> bool:
    """Whether two runs may be averaged: what is set anew from its record is of one run alone."""
    return not (a.restarts or b.restarts) and same_inputs(a, b)


def replicates(replays: Sequence[Replay]) -> list[list[Replay]]:
    """Groups of two or more runs with the same inputs, each by what its runs measured.

    Not in the order of the file, which is to have no say in what they differ by.
    """
    groups = put_together(replays, same_inputs, _place)
    return [sorted(group, key=_place) for group in groups if len(group) > 1]


def _place(replay: Replay) -> tuple:
    """Where a run is among those with the same inputs: by what was logged beside, then by all else.

    By where each channel ends: of courses along one line this makes the fewest groups.
    """
    beside = sorted((name, _last(np.max, x)) for name, x in replay.logged.items())
    seen = sorted((name, _last(np.mean, o.values)) for name, o in replay.observed.items())
    return beside, seen, [event.level for event in replay.breakaways]


def _last(of: Callable[[np.ndarray], float], values: np.ndarray) -> float:
    """Some number of those that are known; infinite, and so last, where none is."""
    known = values[np.isfinite(values)]
    return float(of(known)) if known.size else np.inf


def _mean(group: Sequence[Replay]) -> Replay:
    if len(group) == 1:
        return group[0]
    observed = {}
    for channel, first in group[0].observed.items():
        values = np.mean([r.observed[channel].values for r in group], axis=0)
        keep = np.all([r.observed[channel].keep for r in group], axis=0)
        observed[channel] = Observation(values, first.sd, keep, first.weight, own=first.own)
    name = f"{group[0].name} (mean of {len(group)})"
    in_all = [c for c in group[0].logged if all(c in r.logged for r in group)]
    logged = {c: np.mean([r.logged[c] for r in group], axis=0) for c in in_all}
    return replace(group[0], name=name, observed=observed, replicates=len(group), logged=logged)
