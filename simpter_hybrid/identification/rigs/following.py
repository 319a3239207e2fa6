"""What each run gives to effects: courses of logged channels, and what had been told before it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ...effect import Effect
from ...effects.drive_lag import DriveLag
from ..fitting.replay import Replay
from ..recordings.smoothing import moving_mean

#: Points of a course, over a run: what changes faster is no temperature.
POINTS = 48
#: A run begins in motion if its first speed is more than this part of its largest.  Of runs from
#: rest that begin with a step, an encoder of 2000 counts and rows of 4 ms show more of it in none
#: that reaches 2 rad/s, and in a fifth of those that reach 0.5 rad/s.
MOVES = 0.3


def with_room(effects: Sequence[Effect]) -> tuple[Effect, ...]:
    """Pad each effect that follows a channel with constant points, as many as a course needs.

    Until it is given such a course the effect does as before.
    """
    return tuple(_with_room(e) if e.follows() else e for e in effects)


def _with_room(effect: Effect) -> Effect:
    points = effect.points  # type: ignore[attr-defined]
    last, value = points[-1]
    more = tuple((last + 1.0 + k, value) for k in range(POINTS - len(points)))
    return replace(effect, points=(*points, *more))  # type: ignore[call-arg]


def following(
    parameters: np.ndarray,
    names: Mapping[str, int],
    effects: Sequence[Effect],
    replay: Replay,
) -> np.ndarray:
    """Parameters in which the effects that follow a channel have its course in this run.

    Where it was not logged they keep their own points.

    Parameters
    ----------
    parameters : ndarray (np,)
    names : mapping of str to int
        Entries of `parameters` by name.
    effects : sequence of Effect
        Those of the scenario that is run, in its order.
    replay : Replay
    """
    for number, effect in enumerate(effects, 1):
        level = logged_level(replay, effect.follows())
        if level is None:
            continue
        count = len(effect.points)  # type: ignore[attr-defined]
        at = np.linspace(0.0, replay.time[-1], count)
        smooth = moving_mean(level, 2 * (level.size // (2 * count)) + 1)
        course = np.interp(at, replay.time, smooth)
        points = tuple(zip(at.tolist(), course.tolist(), strict=True))
        table = replace(effect, points=points).table()  # type: ignore[call-arg]
        first = names[f"effect.{number}.{type(effect).__name__}.table.0"]
        parameters = parameters.copy()
        parameters[first : first + len(table)] = table
    return parameters


def begun_in_motion(
    parameters: np.ndarray,
    names: Mapping[str, int],
    effects: Sequence[Effect],
    moving: Callable[[], Mapping[int, float]],
) -> np.ndarray:
    """Parameters in which each late driver begins with what moves its coordinate [V].

    Parameters
    ----------
    parameters : ndarray (np,)
    names : mapping of str to int
        Entries of `parameters` by name.
    effects : sequence of Effect
        Those of the scenario that is run, in its order.
    moving : callable
        Coordinate -> its first input, of each that moves as the run begins; asked if need be.
    """
    late = [
        (effect.coordinate, names[f"effect.{number}.{type(effect).__name__}.begun"])
        for number, effect in enumerate(effects, 1)
        if isinstance(effect, DriveLag)
    ]
    told = moving() if late else {}
    parameters = parameters.copy() if late else parameters
    for coordinate, entry in late:
        parameters[entry] = told.get(coordinate, parameters[entry])
    return parameters


def logged_level(replay: Replay, channel: str) -> np.ndarray | None:
    """What was logged of a channel in a run (samples,) [SI], also one value for all of it."""
    if channel in replay.logged:
        return replay.logged[channel]
    if channel in replay.setting:
        return np.full(replay.time.size, replay.setting[channel])
    return None


def known_levels(replays: Sequence[Replay], channel: str) -> np.ndarray:
    """What was logged of a channel in all runs, one after another (all samples,) [SI].

    Empty where a run is without it.
    """
    levels = [logged_level(r, channel) for r in replays]
    known = [level for level in levels if level is not None]
    return np.concatenate(known) if len(known) == len(levels) else np.zeros(0)
