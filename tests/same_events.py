"""Whether two accounts of a run tell the same story: modes in turn, and when."""

from __future__ import annotations

import pytest

FREE, PENDING = 2, 3
#: Transitions closer together than this are one [s]: their order within an instant is a convention.
INSTANT = 1e-9


def story(events) -> list[tuple[float, tuple[int, ...]]]:
    """(t, modes after) of every instant at which modes changed, from pairs (t, modes after)."""
    found: list[tuple[float, tuple[int, ...]]] = []
    for t, after in events:
        mode = tuple(FREE if v == PENDING else int(v) for v in after)
        if found and t - found[-1][0] < INSTANT:
            found[-1] = (found[-1][0], mode)
        elif not found or found[-1][1] != mode:
            found.append((t, mode))
    return found


def story_of(trajectory) -> list[tuple[float, tuple[int, ...]]]:
    """The story of a trajectory."""
    return story((e.t, e.after) for e in trajectory.events)


def first_difference(one, other, tolerance: float) -> str:
    """Where two stories part, or ''; instants may differ by ``tolerance`` [s]."""
    for k in range(max(len(one), len(other))):
        a = one[k] if k < len(one) else None
        b = other[k] if k < len(other) else None
        if a is None or b is None or a[1] != b[1] or abs(a[0] - b[0]) > tolerance:
            return f"number {k}: {a} against {b}"
    return ""


def assert_agree(found, other, instants: float, states: float, which) -> None:
    """A trajectory tells what an independent event automaton tells, and ends where it ends."""
    assert found.status == "finished", found.message
    told = story((t, after) for t, _, _, after in other.events)
    assert not first_difference(story_of(found), told, instants), which
    assert found.end[:8] == pytest.approx(other.y, abs=states), which
