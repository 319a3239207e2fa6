"""What could follow at an instant: every combination of modes, tried one by one.

The engine resolves a transition by a rule (``kernel.resolution``); here the rule is replayed step
by step, and beside it all successors that the equations allow are enumerated, so that a reader
sees what was chosen from.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from ..kernel.instant import FACET, begin_instant, close_span, gather
from ..kernel.records import BACKWARD, FORWARD, STICK
from ..kernel.resolution import facet_decides, resolve
from ..measuring.evaluation import Evaluation
from .facets import facet_strength, numbered

CONSISTENT, LIMIT, REFUSED = "consistent", "at its limit", "refused"

#: Most clutches at zero slip for which all 3^k successors are tried.
MOST = 6
#: Share of the terms it is the difference of, below which a margin or acceleration is at its limit.
NEAR = 1e-9


@dataclass(frozen=True)
class Candidate:
    """One combination of modes that might follow.

    Parameters
    ----------
    mode : tuple of int, (m,)
    verdict : str
        ``consistent``; ``at its limit`` (a margin or a slip acceleration is zero to rounding);
        ``refused``.
    reason : str
        What is at its limit or speaks against it.
    """

    mode: tuple[int, ...]
    verdict: str
    reason: str = ""


@dataclass(frozen=True)
class Round:
    """One application of the rule.

    Parameters
    ----------
    zero : tuple of int
        Engaged clutches at zero slip (from 1).
    may_hold : tuple of int
        Those of them that may hold up to their breakaway torque.
    by_facet : bool
        Whether the broken facet alone gave the directions.
    let_go : tuple of int
        Those of ``may_hold`` that slip in the solution and were released.
    after : tuple of int, (m,)
        Modes found.
    least_margin : float
        Least margin of the mode found [N m]; negative: another round follows.
    """

    zero: tuple[int, ...]
    may_hold: tuple[int, ...]
    by_facet: bool
    let_go: tuple[int, ...]
    after: tuple[int, ...]
    least_margin: float


def replay(
    view: Evaluation, t: float, y: list[float], cause: int, which: int, margin: float
) -> list[Round]:
    """The rounds of ``kernel.instant.settle`` from the modes, gates and held inputs in ``view.w``.

    ``view`` has to be prepared for the mode before (its facets are those that may have broken).
    """
    md, w, y = view.md, view.w, list(y)
    rounds: list[Round] = []
    w.stamp[0] = np.nan
    begin_instant(md, t, w)
    for _ in range(8 * md.m + 8):
        md.map(y, md.p, w.C)
        gather(md, y, w, cause, which)
        close_span(md, y, w)
        md.terms(t, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)
        zero, might = _flagged(w.zero, md.m), _flagged(w.hold, md.m)
        by_facet = facet_decides(md.m, w.fr, list(w.mode), w.pattern, margin, w.released)
        resolve(md.n, md.m, w.M, w.f, w.C, w.c, w.fr, w.mode, w.zero, w.hold, w.pattern, margin, w)
        let_go = tuple(i for i in might if view.mode[i - 1] != STICK)
        view.prepare(y)
        view.at(t, y)
        margins = view.margins()
        margin = min(margins, default=np.inf)
        rounds.append(Round(zero, might, by_facet, let_go, view.mode, margin))
        if margin >= 0.0:
            break
        cause, which = FACET, margins.index(margin)
    return rounds


def _flagged(flags: list[int], m: int) -> tuple[int, ...]:
    return tuple(i + 1 for i in range(m) if flags[i] == 1)


def successors(
    view: Evaluation, t: float, y: list[float], mode: tuple[int, ...], zero: tuple[int, ...]
) -> list[Candidate]:
    """All modes that the clutches ``zero`` (from 1) may take; the others keep those in ``mode``.

    Empty for more than ``MOST`` clutches.
    """
    if len(zero) > MOST:
        return []
    found = []
    for choice in itertools.product((STICK, FORWARD, BACKWARD), repeat=len(zero)):
        tried = list(mode)
        for i, new in zip(zero, choice, strict=True):
            tried[i - 1] = new
        found.append(judge(view, t, y, tuple(tried), zero))
    return found


def judge(
    view: Evaluation, t: float, y: list[float], mode: tuple[int, ...], zero: tuple[int, ...]
) -> Candidate:
    """Whether ``mode`` can follow at (t, y): what sticks can be held, what slips moves its way."""
    md, w = view.md, view.w
    per, unit = view.scenario.device.surface_units
    w.mode[: md.m] = mode
    y = list(y)
    view.prepare(y)
    resting = view.at_rest()
    view.at(t, y)
    idle: list[int] = []
    for i in zero:
        direction = mode[i - 1]
        if direction == STICK:
            continue
        if resting[i - 1]:
            return Candidate(mode, REFUSED, f"the stuck clutches leave clutch {i} no motion")
        gain = direction * slip_acceleration(view, i - 1)
        size = acceleration_size(view, i - 1)
        if gain < -NEAR * size:
            return Candidate(
                mode,
                REFUSED,
                f"clutch {i} would accelerate the other way ({direction * gain:+.4g} {per}^2)",
            )
        if gain <= NEAR * size:
            idle.append(i)
    limits = [f"{numbered(idle)} would start without acceleration"] if idle else []
    for k, margin in enumerate(view.margins()):
        available, names = facet_strength(view, k)
        if margin < -NEAR * available:
            return Candidate(
                mode,
                REFUSED,
                f"{names} would need {available - margin:.5g} {unit} "
                f"of {available:.5g} {unit} available",
            )
        if margin <= NEAR * available:
            limits.append(f"{names} can just be held")
    return Candidate(mode, LIMIT if limits else CONSISTENT, "; ".join(limits))


def slip_acceleration(view: Evaluation, i: int) -> float:
    """Slip acceleration of clutch ``i`` (from 0) in the mode evaluated [rad/s^2]."""
    n, w = view.md.n, view.w
    drift = 0.0 if view.md.constant else w.c[i]
    return drift + sum(w.C[i * n + j] * w.qdd[j] for j in range(n))


def acceleration_size(view: Evaluation, i: int) -> float:
    """Size of the terms whose sum is the slip acceleration of clutch ``i`` [rad/s^2]."""
    n, m, w = view.md.n, view.md.m, view.w
    mass, clutch_map = np.reshape(w.M, (n, n)), np.reshape(w.C[: m * n], (m, n))
    load = abs(np.array(w.f)) + abs(clutch_map).T @ np.array(w.fr[m : 2 * m])
    return float(abs(clutch_map[i]) @ abs(np.linalg.inv(mass)) @ load)
