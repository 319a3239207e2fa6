"""The replicate floor: what no model of these runs could predict.

Runs with the same inputs differ by noise alone (and by what scatters: breakaway).  Half the
variance of the difference of two is the variance of one run about what is common to both.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np
from scipy.optimize import linear_sum_assignment

from .replay import Breakaway, Observation, Replay
from .replicates import replicates
from .residual import BREAKAWAY_WEIGHT, CLIP

#: Breakaways of two replicates fewer samples apart, and the same way, are the same one.
SAME_BREAKAWAY = 100
#: Name of these among channels, and the fewest differences that tell their scatter: to a quarter.
EVENTS, EVENTS_TOLD = "breakaway", 8


class Floors(NamedTuple):
    """Error of a perfect model on the runs that fit, select and report, in standard deviations.

    One motion lets noise of what drives it move a prediction further than another.
    """

    fit: float
    select: float
    report: float


class Weighed(NamedTuple):
    """Residuals, or noise, of one channel of one run, as a fit weighs them.

    Parameters
    ----------
    channel : str
    values : ndarray (samples,)
    unit : float
        Their root mean square if the sensor's noise (`Observation.own`) were all there is.
    """

    channel: str
    values: np.ndarray
    unit: float = 1.0


def apart(group: Sequence[Replay], channel: str) -> list[np.ndarray]:
    """Differences of replicates in a channel, scaled to the noise of one run [SI].

    One series less than there are runs, each independent of the others (Helmert's contrasts), over
    the rows that are compared in all.
    """
    seen = [replay.observed[channel] for replay in group]
    keep = np.all([one.keep for one in seen], axis=0)
    values = [one.values[keep] for one in seen]
    return [
        (sum(values[:k]) - k * values[k]) / np.sqrt(k * (k + 1.0)) for k in range(1, len(values))
    ]


def replicate_floor(replays: Sequence[Replay]) -> dict[str, float]:
    """Root mean square per channel [SI] that replicates leave: no model can do better.

    Channels without replicates are left out; ``breakaway`` is relative.
    """
    squares: dict[str, list[np.ndarray]] = {}
    for group in replicates(replays):
        for channel in group[0].observed:
            squares.setdefault(channel, []).extend(e**2 for e in apart(group, channel))
        levels = [_levels_apart(a, b) for a, b in combinations(group, 2)]
        squares.setdefault("breakaway", []).extend(levels)
    joined = {channel: np.concatenate(every) for channel, every in squares.items()}
    return {channel: float(np.sqrt(np.mean(e))) for channel, e in joined.items() if e.size}


def _common(a: Replay, b: Replay) -> list[tuple[Breakaway, Breakaway]]:
    """Breakaways that both runs have: as many pairs as may be, the nearest ones.

    By their instants and ways, not by their numbers: one that a run misses would set all later ones
    off by one.
    """
    if not (a.breakaways and b.breakaways):
        return []
    between = np.array([[float(x.index - y.index) for y in b.breakaways] for x in a.breakaways])
    ways = [np.sign([one.level for one in run.breakaways]) for run in (a, b)]
    may = (np.abs(between) < SAME_BREAKAWAY) & (np.outer(*ways) >= 0.0)
    # Squares keep the order of those that are near one another; no number of pairs costs as much
    # as one less of them does.
    without = len(a.breakaways) * float(SAME_BREAKAWAY) ** 2
    pairs = zip(*linear_sum_assignment(np.where(may, between**2, without)), strict=True)
    return [(a.breakaways[i], b.breakaways[j]) for i, j in pairs if may[i, j]]


def _levels_apart(a: Replay, b: Replay) -> np.ndarray:
    """Squared relative differences of the levels of common breakaways, scaled to one run."""
    both = _common(a, b)
    return np.array(
        [2 * ((x.level - y.level) / (abs(x.level) + abs(y.level))) ** 2 for x, y in both]
    )


def noise_floor(replays: Sequence[Replay], factors: Mapping[str, float] | None = None) -> float:
    """Error of a perfect model if sensors' noise (`Observation.own`) were all there is.

    Of every window's rows two go with the line that its start leaves; breakaways scatter.

    Parameters
    ----------
    replays : sequence of Replay
    factors : mapping of str to float, optional
        Channel -> how many times its noise repeated runs differ by (`noise_factors`).
    """
    times = factors or {}
    every = [(c, o) for r in replays for c, o in r.observed.items()]
    events = sum(len(r.breakaways) for r in replays)
    square = sum(_free_rows(o) * (o.weight * o.own * times.get(c, 1.0)) ** 2 for c, o in every)
    square += events * (BREAKAWAY_WEIGHT * times.get(EVENTS, 1.0)) ** 2
    return float(np.sqrt(square / max(1, sum(int(o.keep.sum()) for _, o in every) + events)))


def floors_of(fitted: Sequence[Replay], parts: Mapping[str, Sequence[Replay]]) -> Floors:
    """Floors of parts, each by its own rows and weights, by what repeated runs differ by.

    A channel counts differently in runs of one kind and another (a speed that is set anew from the
    record little), and a part need not have the kinds that were repeated.

    Parameters
    ----------
    fitted : sequence of Replay
        The fitted runs, repeated ones apart.
    parts : mapping of str to sequence of Replay
        ``fit``, ``select``, ``report``, as their errors are taken.  One of which nothing is
        compared has the floor of the fitted ones.
    """
    factors = noise_factors(fitted)
    found = {part: noise_floor(parts[part], factors) for part in Floors._fields}
    return Floors(*(found[part] or found["fit"] for part in Floors._fields))


def _free_rows(seen: Observation) -> float:
    """Rows that are compared, less their part of the line that is taken from each window."""
    if not (seen.windows and seen.lines):
        return float(seen.keep.sum())
    ends = (*seen.windows[1:], seen.keep.size)
    pieces = [seen.keep[a:b] for a, b in zip(seen.windows, ends, strict=True)]
    return float(sum(k.sum() * max(0.0, 1.0 - 2.0 / k.size) for k in pieces if k.size))


def replicate_noise(replays: Sequence[Replay]) -> list[Weighed]:
    """What runs with the same inputs differ by, as a fit weighs it; none without such runs."""
    found = [
        Weighed(channel, np.clip(error / seen.sd, -CLIP, CLIP) * seen.weight, unit_of(seen))
        for group in replicates(replays)
        for channel, seen in group[0].observed.items()
        for error in apart(group, channel)
    ]
    return [series for series in found if series.values.size]


def unit_of(seen: Observation) -> float:
    """Root mean square of weighed residuals if the sensor's noise were all there is."""
    return seen.weight * seen.own


def _breakaway_noise(replays: Sequence[Replay]) -> list[Weighed]:
    """What common breakaways of runs with the same inputs differ by, as a fit weighs it.

    Of each two of them: of three runs in a row what the first and the last differ by would have no
    say.  As k runs have k - 1 independent differences, each pair counts for 2 / k.
    """
    found = []
    for group in replicates(replays):
        counts = BREAKAWAY_WEIGHT * np.sqrt(2.0 / len(group))
        for a, b in combinations(group, 2):
            apart = [(abs(x.level) - abs(y.level)) / np.hypot(x.sd, y.sd) for x, y in _common(a, b)]
            found.append(Weighed(EVENTS, counts * np.clip(apart, -CLIP, CLIP), counts))
    return [series for series in found if series.values.size]


def noise_factors(replays: Sequence[Replay]) -> dict[str, float]:
    """Channel -> root mean square that repeated runs differ by, over that of its noise.

    Over all rows that are compared in them, as a fit weighs these.  Left out, and known by its
    noise alone, is what was not repeated, came again to the last digit (copies), or is too few
    breakaways to tell.
    """
    noise = [*replicate_noise(replays), *_breakaway_noise(replays)]
    by_channel: dict[str, list[Weighed]] = {}
    for series in noise:
        by_channel.setdefault(series.channel, []).append(series)
    events = sum(s.values.size * s.unit**2 for s in by_channel.get(EVENTS, ()))
    if events < EVENTS_TOLD * BREAKAWAY_WEIGHT**2:
        by_channel.pop(EVENTS, None)
    found = {c: float(np.sqrt(over_noise(every))) for c, every in by_channel.items()}
    return {channel: factor for channel, factor in found.items() if factor > 0.0}


def over_noise(every: Sequence[Weighed]) -> float:
    """Sum of squares over what the sensor's noise alone would make it."""
    square = sum(float(s.values @ s.values) for s in every)
    return square / sum(s.values.size * s.unit**2 for s in every)


def weighted_floor(replays: Sequence[Replay]) -> float:
    """What a perfect model would score on the runs that are repeated [standard deviations].

    NaN where none is, or where they are copies.
    """
    repeated = [run for group in replicates(replays) for run in group]
    factors = noise_factors(repeated)
    return noise_floor(repeated, factors) if factors else float("nan")
