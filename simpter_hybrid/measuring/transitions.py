"""Transitions to and from zero slip velocity, counted as the thesis counts them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..kernel.records import BACKWARD, FORWARD
from ..trajectory import Trajectory
from .evaluation import Evaluation, states


@dataclass(frozen=True)
class Transitions:
    """Transitions of every clutch.

    **Counting rule.** A *flat portion* of a clutch's slip velocity is a longest interval of
    positive length during which it is zero because the modes say so: the clutch is stuck, or the
    stuck ones bring it to rest (it may then even be off). A portion counts once, however many
    modes it passes through; one that begins or ends with the run counts too, unless it is the whole
    run. (The flat portions of the thesis's Figure 38, two and four, add up to the six transitions
    of its 5.4.2.) A stop that lets go at once, a *reversal*, takes no time and leaves no flat
    portion.

    Parameters
    ----------
    flat : tuple of tuple of (float, float), (m,)
        First and last instant of the flat portions of every clutch [s].
    reversals : tuple of int, (m,)
        How often an engaged clutch turned from one slip direction to the other without resting.
    """

    flat: tuple[tuple[tuple[float, float], ...], ...]
    reversals: tuple[int, ...]

    @property
    def counts(self) -> tuple[int, ...]:
        """Flat portions of every clutch; (m,)."""
        return tuple(len(portions) for portions in self.flat)

    @property
    def total(self) -> int:
        """Flat portions of all clutches."""
        return sum(self.counts)


def transitions(trajectory: Trajectory) -> Transitions:
    """Count the transitions of a run; see ``Transitions`` for the rule."""
    view = Evaluation(trajectory)
    m = view.md.m
    flat: list[list[list[float]]] = [[] for _ in range(m)]
    reversals = [0] * m
    last: tuple[int, ...] | None = None
    known: dict[tuple[int, ...], list[bool]] = {}
    begins = trajectory.segment_t[:, 0]
    starts = states(trajectory, begins, np.arange(begins.size)).tolist()
    for k, (start, end) in enumerate(trajectory.segment_t.tolist()):
        if end <= start:
            continue
        mode = tuple(trajectory.mode[k].tolist())
        if mode not in known or not view.md.constant:
            view.enter(k, starts[k])
            known[mode] = view.at_rest()
        for i, rests in enumerate(known[mode]):
            if rests and flat[i] and flat[i][-1][1] == start:
                flat[i][-1][1] = end
            elif rests:
                flat[i].append([start, end])
            if last is not None and {last[i], mode[i]} == {FORWARD, BACKWARD}:
                reversals[i] += 1
        last = mode
    whole = [0.0, trajectory.t_end]
    portions = tuple(tuple((a, b) for a, b in rests if [a, b] != whole) for rests in flat)
    return Transitions(portions, tuple(reversals))
