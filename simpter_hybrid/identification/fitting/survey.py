"""What every candidate would do, simulated once: which are worth a fit, and what the data can see.

A candidate is switched on at its starting values (or, where those do nothing, moved by its typical
size) and the change of all residuals is kept.  How much of the residual a multiple of that change
takes away, the declared parameters moving along, ranks the candidates.  A change of full size is
used and not a derivative, since the information often sits in event times; and the ranking only
orders and thins out: what is kept is fitted by the simulation itself.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass

import numpy as np

from ..recordings.projection import beyond
from .effort import effort_of
from .fit import Fitter
from .predictor import Candidate, Parameter
from .replay import Replay

#: Always fitted: this many of the best, and all with this part of the best's linear gain ...
LEAST_KEPT, WORTH = 4, 0.15
#: ... and those to which a located dependence belongs, if they gain this part of it.  So do all
#: where runs are followed whole and the model leaves so many floors: there one step tells little
#: (of a drum that ran down a quadratic drag promised a fifteenth of what a friction that warms up
#: did, and took it all away).
WORTH_IF_LOCATED, FAR_OFF = 0.02, 10.0
#: A richer form is tried where its simpler one takes away this part of the sum of squares; at the
#: floor any candidate.  Nulls promise 0.0013 at most, effects that few runs show 0.02 and more.
PROMISE = 2e-3
#: A fit begins at the size that a linear step asks for, but at no more than so many times the
#: start's size; beyond that only if the larger size does better.
LARGEST = 5.0


@dataclass(frozen=True)
class Probe:
    """One candidate switched on.

    Parameters
    ----------
    candidate : Candidate
    fitter : Fitter
        Knows the base's columns, and the candidate's own where the start does nothing.
    start : mapping of str to float
        Values of all parameters from which its fit begins.
    residuals : ndarray (N,)
        There, with the rows of the declared tolerances.
    gain : float
        Part of the base's sum of squares that one linear step takes away.
    scaled : tuple of mapping of str to float
        `start` with the sizes that such steps ask for, up to `LARGEST` times those of the start and
        all of them, and the other parameters moved along; empty where the start does nothing.
    """

    candidate: Candidate
    fitter: Fitter
    start: Mapping[str, float]
    residuals: np.ndarray
    gain: float
    scaled: tuple[Mapping[str, float], ...]


def survey(base, candidates: Sequence[Candidate], replays: Sequence[Replay]) -> list[Probe]:
    """A probe for every candidate that `base` does not have, in their order."""
    seen = base.residuals
    present = {c.name for c in base.effects}
    found: dict[str, Probe] = {}
    for candidate in candidates:
        if effort_of(base.predictor).used_up:
            break
        simpler = found.get(candidate.simpler)
        if candidate.name in present or (simpler is not None and simpler.gain < PROMISE):
            continue
        found[candidate.name] = _probe(base, candidate, replays, seen)
    return list(found.values())


def followed_far_off(base, replays: Sequence[Replay], floor: float) -> bool:
    """Whether a model is far off the floor, and runs are followed whole."""
    return base.select_error > FAR_OFF * floor and any(run.followed for run in replays)


def _probe(base, candidate: Candidate, replays: Sequence[Replay], seen: np.ndarray) -> Probe:
    names = [p.name for p in candidate.parameters]
    known = {n: c for n, c in base.columns.items() if n not in names}
    fitter = Fitter(base.predictor.extended(candidate), replays, known, unit=base.unit)
    bound = {p.name for p in fitter.parameters if base.values.get(p.name) in (p.lower, p.upper)}
    best = None
    starts = [dict(zip(names, start, strict=True)) for start in candidate.starts]
    for start in (*starts, *([dict(candidate.fitted)] if candidate.fitted else ())):
        values = {**base.values, **start}
        if all(values[p.name] == p.value for p in candidate.parameters):
            columns = _typical_columns(fitter, candidate, values, seen)
            fitter.known |= columns
            change = np.sum(list(columns.values()), axis=0)
            own, at = np.column_stack(list(columns.values())), seen
        else:
            at = fitter.residuals(values)[: seen.size]
            change = at - seen
            own = _by_size(fitter, candidate, values, seen, change)
        steps = _steps(seen, known, bound, own)
        # A start that an earlier search has fitted may be better than any linear step promises.
        gain = max(steps[0][0], 1.0 - float(at @ at) / float(seen @ seen))
        if best is None or gain > best.gain:
            scaled: tuple[Mapping[str, float], ...] = ()
            if at is not seen:
                scaled = tuple(
                    _moved(fitter, _scaled(candidate, values, step, most), beside)
                    for _, step, beside in steps
                    for most in (LARGEST, np.inf)
                )
            at = fitter.with_prior(at, values)
            best = Probe(candidate, fitter, values, at, gain, scaled)
    assert best is not None
    return best


def _steps(
    seen: np.ndarray, known: Mapping[str, np.ndarray], bound: Set[str], own: np.ndarray
) -> list[tuple[float, np.ndarray, dict[str, float]]]:
    """Linear steps, the more promising first: gain, multiples, and how known parameters go along.

    One step is taken with all known parameters free, one with those at their bounds (`bound`) held:
    such a parameter must not take away beforehand what it could explain only without its bound.
    """
    found = []
    for held in (set(), bound) if bound else (set(),):
        free = {name: column for name, column in known.items() if name not in held}
        gain, step, along = linear_step(seen, list(free.values()), own)
        found.append((gain, step, dict(zip(free, along, strict=True))))
    return sorted(found, key=lambda f: -f[0])


def _typical_columns(
    fitter: Fitter, candidate: Candidate, values: Mapping[str, float], seen: np.ndarray
) -> dict[str, np.ndarray]:
    """Changes by each parameter's typical size, which are columns of the Jacobian as well."""
    found = {}
    for p in candidate.parameters:
        h = p.difference(values[p.name], p.typical)
        moved = fitter.residuals({**values, p.name: values[p.name] + h})[: seen.size]
        found[p.name] = (moved - seen) * (p.typical / h)
    return found


def _sized(candidate: Candidate) -> list[Parameter]:
    """Parameters of a candidate that are fitted and say how large it is."""
    return [p for p in candidate.parameters if p.name in candidate.sizes]


def _by_size(
    fitter: Fitter,
    candidate: Candidate,
    values: Mapping[str, float],
    seen: np.ndarray,
    change: np.ndarray,
) -> np.ndarray:
    """Change of the residuals by each size of a candidate alone (N, sizes).

    `change` is what all sizes do together.  What is missing at one clutch is not a multiple of what
    the same size at every clutch does, so each is asked by itself.
    """
    sizes = _sized(candidate)
    if len(sizes) < 2:
        return change[:, None]
    columns = []
    for p in sizes:
        off = {q.name: q.value for q in sizes if q is not p}
        columns.append(fitter.residuals({**values, **off})[: seen.size] - seen)
    return np.column_stack(columns)


def _scaled(
    candidate: Candidate, values: Mapping[str, float], step: np.ndarray, most: float
) -> Mapping[str, float]:
    times = np.clip(step, -most, most)
    sizes = _sized(candidate)
    by = np.broadcast_to(times, len(sizes)) if sizes else ()
    changed = {
        p.name: float(np.clip(t * values[p.name], p.lower, p.upper))
        for p, t in zip(sizes, by, strict=True)
    }
    return {**values, **changed}


def _moved(
    fitter: Fitter, values: Mapping[str, float], steps: Mapping[str, float]
) -> Mapping[str, float]:
    """Values with steps in typical sizes, within bounds."""
    found = dict(values)
    for p in fitter.parameters:
        if p.name in steps:
            found[p.name] = float(
                np.clip(values[p.name] + p.typical * steps[p.name], p.lower, p.upper)
            )
    return found


def linear_step(
    residuals: np.ndarray, base: Sequence[np.ndarray], own: np.ndarray
) -> tuple[float, np.ndarray, np.ndarray]:
    """What columns `own` (N, k) can do for `residuals` (N,) beyond columns `base`.

    Returns
    -------
    float
        Part of the sum of squares that they take away.
    ndarray (k,)
        The multiples of them that do so.
    ndarray (base,)
        The multiples of `base` that go with these.
    """
    left = np.column_stack(list(base)) if base else np.zeros((residuals.size, 0))
    alone = beyond(own, left)
    normal, slope = alone.T @ alone, alone.T @ residuals
    size = np.sqrt(np.diag(normal)) + 1e-30
    scaled = np.linalg.lstsq(normal / np.outer(size, size), -slope / size, rcond=1e-9)[0]
    gain = -float(scaled @ (slope / size)) / float(residuals @ residuals)
    step = scaled / size
    return gain, step, np.linalg.lstsq(left, -(residuals + own @ step), rcond=None)[0]


def worth_fitting(
    probes: Sequence[Probe], located: Sequence[str], blind: bool = False
) -> list[Probe]:
    """Probes that are fitted, the most promising first; of a size for each only promising ones.

    Parameters
    ----------
    probes : sequence of Probe
    located : sequence of str
        Dependences of the base's residual.
    blind : bool
        Whether a linear step tells little: see `followed_far_off`.
    """
    order = sorted(probes, key=lambda p: -p.gain)
    most = max((p.gain for p in probes), default=0.0)
    worth = WORTH_IF_LOCATED if blind else WORTH
    return [
        p
        for k, p in enumerate(order)
        if p.gain >= worth * most
        or (k < LEAST_KEPT and not p.candidate.plain)
        or (
            set(located) & set(p.candidate.coordinates)
            and p.gain >= WORTH_IF_LOCATED * most
            and not p.candidate.plain
        )
    ]
