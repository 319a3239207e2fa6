"""The ways in which a stuck set can give in, with what is needed and available along each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..measuring.evaluation import Evaluation, states

#: Interval over which rates of change are taken [s].
LOOK_BACK = 1e-4
#: An excitation fell if it lost more than this share of itself within it: less is rounding, or the
#: last of a fall long ago.
FELL = 1e-9


@dataclass(frozen=True)
class Facet:
    """One way in which a stuck set can give in: some of its clutches let go together.

    Parameters
    ----------
    name : str
        The clutches and the directions in which they would slip.
    pattern : tuple of float, (m,)
        Share of every clutch's torque in the sums below; for a set that is not redundant one entry.
    needed, available : float
        Torque along the facet to hold the set, and the most it can give [N m].
    needed_rate, available_rate : float
        Their rates of change just before [N m/s].
    excitation_fell : bool
        Whether that of one of its clutches fell just before.
    """

    name: str
    pattern: tuple[float, ...]
    needed: float
    available: float
    needed_rate: float
    available_rate: float
    excitation_fell: bool

    @property
    def margin(self) -> float:
        """``available - needed`` [N m]."""
        return self.available - self.needed


def facets_at(
    view: Evaluation, segment: int, t: float
) -> tuple[tuple[Facet, ...], tuple[int, ...]]:
    """Facets of the set stuck in ``segment`` at ``t``, least margin first, and who is redundant.

    Leaves ``view`` evaluated at ``t``.
    """
    view.enter(segment)
    run, m = view.trajectory, view.md.m
    earlier = max(t - LOOK_BACK, float(run.segment_t[segment, 0]))
    rows, excitations = [], []
    for instant in (earlier, t):
        y = states(run, np.array([instant]), np.array([segment]))[0].tolist()
        view.at(instant, y)
        margins = view.margins()
        excitations.append(y[2 * view.md.n : 2 * view.md.n + m])
        rows.append([(facet_strength(view, k)[0], margin) for k, margin in enumerate(margins)])
    fell = [new < old * (1.0 - FELL) for old, new in zip(*excitations, strict=True)]
    found: list[Facet] = []
    shown: list[tuple[float, ...]] = []
    for k in range(0, len(rows[1]), 2):
        loaded = min(k, k + 1, key=lambda side: rows[1][side][1])
        (old, old_margin), (available, margin) = rows[0][loaded], rows[1][loaded]
        span = t - earlier
        slope = 1.0 / span if span > 0.0 else 0.0
        sign = 1.0 if loaded == k else -1.0
        pattern = tuple(sign * p for p in view.w.fp[k // 2 * m : k // 2 * m + m])
        if not any(pattern) or any(np.allclose(pattern, each) for each in shown):
            continue  # where a map turns, two may be one in this pose, or one be none
        shown.append(pattern)
        needed, old_needed = available - margin, old - old_margin
        found.append(
            Facet(
                facet_name(list(pattern)),
                tuple(abs(p) for p in pattern),
                needed,
                available,
                (needed - old_needed) * slope,
                (available - old) * slope,
                any(p != 0.0 and less for p, less in zip(pattern, fell, strict=True)),
            )
        )
    redundant = tuple(i + 1 for i, unique in enumerate(view.unique()) if not unique)
    return tuple(sorted(found, key=lambda facet: facet.margin)), redundant


def facet_strength(view: Evaluation, k: int) -> tuple[float, str]:
    """The most that a stuck set can hold along facet ``k // 2`` [N m], and whose facet it is."""
    m, w = view.md.m, view.w
    sign = 1.0 if k % 2 == 0 else -1.0
    pattern = [sign * v for v in w.fp[k // 2 * m : k // 2 * m + m]]
    available = sum(
        p * w.fr[2 * m + i] if p > 0.0 else -p * w.fr[m + i] for i, p in enumerate(pattern)
    )
    return available, facet_name(pattern)


def numbered(clutches: Sequence[int]) -> str:
    """``clutch 2``; ``clutches 1, 3``; ``no clutch``."""
    if not clutches:
        return "no clutch"
    return ("clutch " if len(clutches) == 1 else "clutches ") + ", ".join(map(str, clutches))


def facet_name(pattern: list[float]) -> str:
    """Which clutches let go together, and which way: ``clutches 1 forward, 3 backward``."""
    words = [
        f"{i + 1} {'backward' if p > 0.0 else 'forward'}" for i, p in enumerate(pattern) if p != 0.0
    ]
    return ("clutch " if len(words) == 1 else "clutches ") + ", ".join(words)
