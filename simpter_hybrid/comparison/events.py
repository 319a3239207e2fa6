"""Which stops and releases of one run are those of another."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from ..trajectory import Event, Trajectory
from .states import clutch_maps, states_at

#: Modes of an engaged clutch.
MOVING = (-1, 0, 1)


class Change(NamedTuple):
    """A clutch (from 1) that stops (``to`` 0), or starts to slip, at ``t`` [s]."""

    t: float
    clutch: int
    to: int


class Matching(NamedTuple):
    """``pairs`` of the same change in both runs; ``missed`` and ``invented`` ones."""

    pairs: tuple[tuple[Change, Change], ...]
    missed: tuple[Change, ...]
    invented: tuple[Change, ...]

    @property
    def largest_shift(self) -> float:
        """Largest difference in time within a pair [s]; 0 without pairs."""
        return max((abs(a.t - b.t) for a, b in self.pairs), default=0.0)


def changes(run: Trajectory, until: float) -> list[Change]:
    """Changes between sticking and slipping up to ``until`` [s].

    The start and switching on and off are left out: their instants are known, not found. A clutch
    that passes through several modes at one instant changes once, from the first to the last.
    """
    found: list[Change] = []
    for event in merged(run.events):
        for i, (before, after) in enumerate(zip(event.before, event.after, strict=True)):
            slips = before in MOVING and after in MOVING
            if before != after and slips and event.t <= until:
                found.append(Change(event.t, i + 1, after))
    return found


def merged(events: Iterable[Event]) -> list[Event]:
    """Events with those of one instant put together."""
    found: list[Event] = []
    for event in events:
        if found and found[-1].t == event.t:
            last = found.pop()
            event = Event(
                event.t, event.kind, last.clutches, last.before, event.after,
                last.case_before, event.case_after,
            )  # fmt: skip
        found.append(event)
    return found


def match(reference: list[Change], other: list[Change], window: float) -> Matching:
    """Pair changes of the same clutch to the same mode, the closest in time first.

    Parameters
    ----------
    reference, other : list of Change
    window : float
        Changes further apart than this are not the same one [s].
    """
    near = sorted(
        (abs(a.t - b.t), i, j)
        for i, a in enumerate(reference)
        for j, b in enumerate(other)
        if a.clutch == b.clutch and a.to == b.to and abs(a.t - b.t) <= window
    )
    taken: dict[int, int] = {}
    used: set[int] = set()
    for _, i, j in near:
        if i not in taken and j not in used:
            taken[i] = j
            used.add(j)
    return Matching(
        tuple((reference[i], other[taken[i]]) for i in sorted(taken)),
        tuple(a for i, a in enumerate(reference) if i not in taken),
        tuple(b for j, b in enumerate(other) if j not in used),
    )


class Release(NamedTuple):
    """Clutches that slipped out of a redundant stuck set; ``other`` None: not at that time.

    ``first``: what the other run let go at first, before it had time to get at the right ones.
    """

    t: float
    stuck: tuple[int, ...]
    reference: tuple[int, ...]
    other: tuple[int, ...] | None
    first: tuple[int, ...] | None = None


def slipping(stuck: tuple[int, ...], event: Event) -> tuple[int, ...]:
    """Clutches of ``stuck`` (numbers from 1) that slip after an event."""
    return tuple(i for i in stuck if event.after[i - 1] in (-1, 1))


def redundant_releases(run: Trajectory) -> list[tuple[float, tuple[int, ...], list[Event]]]:
    """Releases out of a redundant stuck set: instant, the set, and the events from it on.

    A set is redundant where it has more clutches than it holds motions.
    """
    events = merged(run.events)
    found = []
    for k, event in enumerate(events):
        stuck = tuple(i + 1 for i, mode in enumerate(event.before) if mode == 0)
        released = slipping(stuck, event) and event.t > 0.0
        if released and len(stuck) > _held(run, event.t, stuck):
            found.append((event.t, stuck, events[k:]))
    return found


def _held(run: Trajectory, t: float, stuck: tuple[int, ...]) -> int:
    """How many motions the clutches ``stuck`` hold at ``t`` [s]; parallel ones hold the same."""
    # A map that is constant is that of any pose: runs without dense output are compared too.
    constant = run.scenario.device.constant_clutch_map
    pose = run.end[np.newaxis] if constant else states_at(run, np.array([t]))
    (rows,) = clutch_maps(run.scenario, pose)
    return int(np.linalg.matrix_rank(rows[[i - 1 for i in stuck]]))


def compare_releases(reference: Trajectory, other: Trajectory, window: float) -> list[Release]:
    """The reference's releases out of Case 7 beside the other run's.

    The other run has ``window`` [s] of time to get at the right clutches: inside a band the
    breakaway torques still act, and others may begin.
    """
    theirs = redundant_releases(other)
    found = []
    for t, stuck, events in redundant_releases(reference):
        if t > other.t_end:
            continue
        right = slipping(stuck, events[0])
        near = [r for r in theirs if abs(r[0] - t) <= window and r[1] == stuck]
        closest = min(near, key=lambda r: abs(r[0] - t), default=None)
        answer, first = None, None
        if closest:
            seen = [slipping(stuck, e) for e in closest[2] if e.t <= closest[0] + window]
            first = seen[0]
            answer = right if right in seen else first
        found.append(Release(t, stuck, right, answer, first))
    return found
